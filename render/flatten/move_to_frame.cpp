// The frame that a flat scene has for itself.

#include <algorithm>
#include <cmath>

#include "render/flatten/flatten.h"

namespace ropelight {
namespace {

Bounds boundsOf(const FlatScene& flat) {
  Bounds bounds;
  for (std::uint32_t i = 0; i < flat.primitiveCount(); ++i)
    bounds.grow(flat.primitiveBounds(i));  // without slack: there is no reach as yet
  return bounds;
}

/// The multiple of the step that is nearest to the middle of the scene.
Vec3d frameOrigin(const Bounds& bounds) {
  Vec3d const extent = bounds.extent();
  double const largest = std::max({extent.x, extent.y, extent.z});
  if (!(largest > 0) || !std::isfinite(largest)) return Vec3d(0.0);
  // The next power of two changes at √2 times powers of two, which no extent is: rounding cannot change the step.
  double const step = std::exp2(std::floor(std::log2(largest) + 2.5));
  return glm::floor((0.5 * (bounds.min + bounds.max)) / step + 0.5) * step;
}

void moveBy(FlatScene& flat, Vec3d offset) {
  for (auto* quads : {&flat.quads, &flat.hiddenFaces})
    for (FlatQuad& quad : *quads)
      for (Vec3d& corner : quad.corner) corner += offset;
  for (FlatSphere& sphere : flat.spheres) sphere.center += offset;
  for (FlatTriangle& t : flat.triangles)
    for (Vec3d* corner : {&t.a, &t.b, &t.c}) *corner += offset;
  for (FlatInstance& instance : flat.instances) {
    instance.toWorld[3] += glm::dvec4(offset, 0.0);
    instance.bounds.min += offset;
    instance.bounds.max += offset;
  }
}

}  // namespace

void moveToFrame(FlatScene& flat) {
  flat.bounds = boundsOf(flat);
  flat.origin = frameOrigin(flat.bounds);
  if (flat.origin == Vec3d(0.0)) return;
  moveBy(flat, -flat.origin);
  flat.bounds = boundsOf(flat);
}

}  // namespace ropelight
