#pragma once
// A whole text file in memory.

#include <filesystem>
#include <string>

namespace ropelight {

/// The bytes of a file. Throws Error with the system's reason; `remedy` ends the message.
std::string readTextFile(const std::filesystem::path& path, const std::string& remedy);

}  // namespace ropelight
