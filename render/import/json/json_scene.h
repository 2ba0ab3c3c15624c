#pragma once
// Our own scene format (docs/scene-format.md).

#include <filesystem>

#include "render/scene/scene.h"

namespace ropelight {

/// Throws Error with file and JSON pointer. What all formats have to fulfil is left to validateScene.
Scene loadJsonScene(const std::filesystem::path& path);

}  // namespace ropelight
