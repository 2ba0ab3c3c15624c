#pragma once
// The "shapes" of a JSON scene.

#include "render/import/json/json_node.h"
#include "render/scene/scene.h"

namespace ropelight {

/// Appends the shapes, and the meshes that they name, to a scene whose materials and file are set.
void readShapes(const JsonNode& node, Scene& scene);

}  // namespace ropelight
