#include "render/flat/flat_scene.h"

#include <algorithm>
#include <cmath>

namespace ropelight {

namespace {

/// Distance range of a box from the origin in a sphere's object space, from the images of its corners and its center.
bool boxMeetsUnitSphere(const FlatSphere& sphere, const Bounds& box) {
  Mat3d const toObject = glm::inverse(sphere.toWorld);
  Vec3d const center = toObject * (0.5 * (box.min + box.max) - sphere.center);
  Vec3d const half = 0.5 * box.extent();
  double reach = 0, farthest = 0;
  for (int i = 0; i < 8; ++i) {
    Vec3d const h = toObject * Vec3d(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z);
    reach = std::max(reach, glm::length(h));
    farthest = std::max(farthest, glm::length(center + h));
  }
  double const d = glm::length(center);
  return farthest >= 1 - 1e-9 && d - reach <= 1 + 1e-9;
}

}  // namespace

std::uint32_t FlatScene::primitiveCount() const {
  return std::uint32_t(quads.size() + spheres.size() + triangles.size() + instances.size());
}

std::uint32_t FlatScene::hitCount() const {
  if (instances.empty()) return primitiveCount();
  return instances.back().firstHit + meshes[instances.back().mesh]->primitiveCount();
}

bool FlatScene::isPolygon(std::uint32_t i) const {
  bool const sphere = i >= quads.size() && i < quads.size() + spheres.size();
  return !sphere && i < quads.size() + spheres.size() + triangles.size();
}

Bounds FlatScene::primitiveBounds(std::uint32_t i) const {
  Bounds b;
  std::size_t const firstTriangle = quads.size() + spheres.size(), firstInstance = firstTriangle + triangles.size();
  if (i < quads.size()) {
    for (Vec3d p : quads[i].corner) b.grow(p);
  } else if (i < firstTriangle) {
    const FlatSphere& s = spheres[i - quads.size()];
    for (int a = 0; a < 3; ++a) {
      double const h = std::hypot(s.toWorld[0][a], s.toWorld[1][a], s.toWorld[2][a]);
      b.min[a] = s.center[a] - h;
      b.max[a] = s.center[a] + h;
    }
  } else if (i < firstInstance) {
    const FlatTriangle& t = triangles[i - firstTriangle];
    for (Vec3d p : {t.a, t.b, t.c}) b.grow(p);
  } else {
    const FlatInstance& instance = instances[i - firstInstance];
    Vec3d const slack = std::ldexp(reach, -19) * instance.slack;
    b = {instance.bounds.min - slack, instance.bounds.max + slack};
  }
  return b;
}

bool FlatScene::overlapsSurface(std::uint32_t i, const Bounds& box) const {
  bool const sphere = i >= quads.size() && i < quads.size() + spheres.size();
  return !sphere || boxMeetsUnitSphere(spheres[i - quads.size()], box);
}

double reachOf(const Bounds& bounds, Vec3d position) {
  Bounds far = bounds;
  far.grow(position);
  far.grow(Vec3d(0.0));
  Vec3d const e = far.extent();
  return std::max({e.x, e.y, e.z});
}

}  // namespace ropelight
