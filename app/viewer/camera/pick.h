#pragma once
// What lies under the cursor, straight from the scene's shapes in double: for focus and selection, not for images.

#include <optional>

#include "render/scene/bounds.h"
#include "render/scene/scene.h"

namespace ropelight::view {

struct Picked {
  int shape = 0;  ///< index into Scene::shapes
  Vec3d point{0};
  double distance = 0;  ///< along the unit direction
};

/// The nearest shape along origin + t·direction, t > 0; direction is a unit vector. Empty where nothing is hit.
std::optional<Picked> pick(const Scene& scene, Vec3d origin, Vec3d direction);

/// Bounds of one shape in the world.
Bounds shapeBounds(const Scene& scene, int shape);
Bounds sceneBounds(const Scene& scene);

}  // namespace ropelight::view
