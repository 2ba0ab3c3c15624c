#pragma once
// {"type": NAME, …} → material, for every kind in MaterialDesc.

#include "render/import/json/json_node.h"
#include "render/scene/scene.h"

namespace ropelight {

/// Keys are the names of the kind's params list, all optional; limits are the list's.
MaterialDesc readMaterial(const JsonNode& node);

}  // namespace ropelight
