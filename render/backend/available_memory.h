#pragma once
// How much host memory this process may still take.

#include <cstdint>
#include <filesystem>
#include <limits>

namespace ropelight {

inline constexpr std::uint64_t unknownMemory = std::numeric_limits<std::uint64_t>::max();

/// Bytes: the least of what the machine has free (swap included), what the control groups of this process leave (what
/// the page cache would give back counts as free), and its own limits (ulimit -v, -d). unknownMemory where nothing
/// tells. root: where proc and sys lie, for tests.
std::uint64_t availableMemory(const std::filesystem::path& root = "/");

/// Bytes that the control groups of this process allow it in all; unknownMemory without a limit.
std::uint64_t groupMemoryLimit(const std::filesystem::path& root = "/");

}  // namespace ropelight
