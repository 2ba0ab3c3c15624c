#pragma once
// Scene files of any known format.

#include <filesystem>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight {

/// Reads a scene file by the format that its extension names, and validates it. Throws Error (badInput).
Scene loadScene(const std::filesystem::path& path);

/// The extensions that loadScene knows, each with its dot.
std::vector<std::string> sceneExtensions();

}  // namespace ropelight
