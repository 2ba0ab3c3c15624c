#pragma once
// A whole text file in memory.

#include <filesystem>
#include <string>

namespace ropelight {

/// The text of a file, without the byte order mark that UTF-8 may start with. Throws Error with the system's reason,
/// where `remedy` ends the message, and where the bytes are UTF-16, UTF-32 or no text.
std::string readTextFile(const std::filesystem::path& path, const std::string& remedy);

}  // namespace ropelight
