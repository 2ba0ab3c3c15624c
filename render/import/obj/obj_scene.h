#pragma once
// A mesh file alone: a scene is made around it.

#include <filesystem>

#include "render/scene/scene.h"

namespace ropelight {

/// The mesh in grey, y up, on the floor of a light room, under a square light, seen by a camera that frames it.
Scene loadObjScene(const std::filesystem::path& path);

}  // namespace ropelight
