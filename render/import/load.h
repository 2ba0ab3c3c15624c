#pragma once
// Scene files of any known format.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight {

/// A format of scene files. A new one is its own folder and a line of the table in load.cpp.
struct Importer {
  std::vector<std::string> extensions;  ///< each with its dot, in lower case
  const char* name;
  Scene (*load)(const std::filesystem::path&);
};

/// Those there are, in the order in which messages list them.
std::span<const Importer> importers();

/// Reads a scene file by the format that its extension names, and validates it. Throws Error (badInput).
Scene loadScene(const std::filesystem::path& path, std::span<const Importer> formats = importers());

/// The extensions of all formats.
std::vector<std::string> sceneExtensions(std::span<const Importer> formats = importers());

}  // namespace ropelight
