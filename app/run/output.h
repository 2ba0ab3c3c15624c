#pragma once
// Files that the command line writes: the check before a long run that they can be written and destroy nothing, and
// the writing.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight {

/// Throws Error (badInput) where a file could not be created or replaced at `path`.
void requireWritable(const std::string& path);

/// Every output must be a file of its own that is no input of the run, by whatever names: relative paths, links and
/// hard links are followed. Throws Error: usage where one is not, badInput where one cannot be written
/// (requireWritable). Empty names and "-" (standard output) are no files.
void requireOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// The first half of it alone, for a file that may be written again: it is no input of the run.
void requireNoInput(const std::string& output, const std::vector<std::string>& inputs);

/// The files that a scene was read from.
std::vector<std::string> filesOf(const Scene& scene);

/// Makes a folder for outputs. Throws Error (badInput).
void makeFolder(const std::string& folder);

/// Writes indented JSON to a file, or to standard output where `path` is "-". Numbers that JSON lacks become null.
/// Throws Error; what was at `path` then stays as it was.
void writeJson(const std::string& path, const nlohmann::ordered_json& json);

/// Calls every writer, so that one full disk does not cost the other outputs; then throws what went wrong first, as
/// Error (internal).
void writeAll(const std::vector<std::function<void()>>& writers);

}  // namespace ropelight
