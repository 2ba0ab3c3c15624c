#pragma once
// Files that the command line writes itself, and the check before a long run that they can be written.

#include <nlohmann/json.hpp>
#include <string>

namespace ropelight {

/// Throws Error (badInput) where a file could not be created or replaced at `path`.
void requireWritable(const std::string& path);

/// Writes indented JSON to a file, or to standard output where `path` is "-". Numbers that JSON lacks become null.
/// Throws Error; what was at `path` then stays as it was.
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

}  // namespace ropelight
