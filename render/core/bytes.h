#pragma once

#include <cstdint>
#include <string>

namespace ropelight {

/// "512 B", "1.5 KiB", "20.0 MiB" …
std::string formatBytes(std::uint64_t bytes);

}  // namespace ropelight
