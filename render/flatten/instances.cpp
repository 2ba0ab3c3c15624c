#include "render/flatten/instances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/scene/transform.h"

namespace ropelight {
namespace {

constexpr double keptReach = 4;  ///< of a mesh within [−1, 1] and rays from within [−2, 2], with room to spare

template <class Visit>
void forEachVertex(std::vector<FlatTriangle>& triangles, Visit&& visit) {
  for (FlatTriangle& t : triangles)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) visit(*p);
}

Mat3d absolute(const Mat3d& m) { return Mat3d(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])); }

}  // namespace

KeptMesh keepMesh(const Mesh& mesh) {
  FlatScene scene;
  scene.triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    scene.triangles.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
  Bounds given;
  forEachVertex(scene.triangles, [&](Vec3d& p) { given.grow(p); });
  Vec3d const center = 0.5 * (given.min + given.max), extent = given.extent();
  double const half = 0.5 * std::max({extent.x, extent.y, extent.z});
  double const scale = half > 0 ? std::ldexp(1.0, std::ilogb(half) + 1) : 1;
  forEachVertex(scene.triangles, [&](Vec3d& p) {
    p = (p - center) / scale;
    scene.bounds.grow(p);
  });
  scene.reach = keptReach;
  return {std::make_shared<const FlatScene>(std::move(scene)), translation(center) * scaling(Vec3d(scale))};
}

Vec3d roundingGrowth(const Mat3d& m) {
  if (glm::determinant(m) == 0) return Vec3d(std::numeric_limits<double>::infinity());
  return absolute(m) * (absolute(glm::inverse(m)) * Vec3d(1.0));
}

double placeInstance(const FlatScene& mesh, FlatInstance& instance) {
  double area = 0;
  Mat3d const linear(instance.toWorld);
  for (const FlatTriangle& t : mesh.triangles) {
    for (Vec3d p : {t.a, t.b, t.c}) instance.bounds.grow(transformPoint(instance.toWorld, p));
    area += 0.5 * glm::length(glm::cross(linear * (t.b - t.a), linear * (t.c - t.a)));
  }
  instance.slack = roundingGrowth(linear);
  return area;
}

}  // namespace ropelight
