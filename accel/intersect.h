#pragma once
// Closest and any hit of a scene: through the kd-tree where there is one, else by testing every primitive.

#include "accel/kd_traverse_ropes.h"
#include "render/scene/view.h"

namespace ropelight::RL_TARGET {

template <FeatureBits F>
RL_HD inline void intersectPrimitive(const SceneView& scene, const Ray& ray, const RayShear& shear, std::uint32_t id,
                                     Hit& hit) {
  std::uint32_t k = id;
  if constexpr ((F & feature::quads) != 0) {
    if (k < scene.quads.size) return intersect(scene.quads[k], ray, shear, id, hit);
  }
  k -= scene.quads.size;
  if constexpr ((F & feature::spheres) != 0) {
    if (k < scene.spheres.size) return intersect(scene.spheres[k], ray, id, hit);
  }
  k -= scene.spheres.size;
  if constexpr ((F & feature::triangles) != 0) intersect(scene.triangles[k], shear, id, hit);
}

/// Every primitive, kind by kind. The reference that every other structure must equal.
template <FeatureBits F>
RL_HD inline Hit closestHitBruteForce(const SceneView& scene, const Ray& ray) {
  Hit hit;
  hit.t = ray.tMax;
  RayShear const shear(ray);
  std::uint32_t id = 0;
  if constexpr ((F & feature::quads) != 0)
    for (std::uint32_t k = 0; k < scene.quads.size; ++k) intersect(scene.quads[k], ray, shear, id++, hit);
  if constexpr ((F & feature::spheres) != 0)
    for (std::uint32_t k = 0; k < scene.spheres.size; ++k) intersect(scene.spheres[k], ray, id++, hit);
  if constexpr ((F & feature::triangles) != 0)
    for (std::uint32_t k = 0; k < scene.triangles.size; ++k) intersect(scene.triangles[k], shear, id++, hit);
  return hit;
}

template <FeatureBits F>
RL_HD inline Hit closestHitTree(const SceneView& scene, const Ray& ray) {
  Hit hit;
  hit.t = ray.tMax;
  RayShear const shear(ray);
  traverseRopes(
      scene.tree, ray, [&](std::uint32_t id) { intersectPrimitive<F>(scene, ray, shear, id, hit); },
      [&](Real t) { return hit.t <= t; });
  return hit;
}

template <FeatureBits F>
RL_HD inline Hit closestHit(const SceneView& scene, const Ray& ray) {
  if constexpr ((F & feature::tree) != 0)
    if (!scene.tree.nodes.empty()) return closestHitTree<F>(scene, ray);
  return closestHitBruteForce<F>(scene, ray);
}

/// Whether anything but `ignored` lies in (0, tMax]. A light's own primitive is ignored: it is convex, so that it never
/// stands between its visible side and a point that sees it.
template <FeatureBits F>
RL_HD inline bool occluded(const SceneView& scene, const Ray& ray, std::uint32_t ignored) {
  RayShear const shear(ray);
  Hit hit;
  hit.t = ray.tMax;
  if constexpr ((F & feature::tree) != 0) {
    if (!scene.tree.nodes.empty()) {
      traverseRopes(
          scene.tree, ray,
          [&](std::uint32_t id) {
            if (id != ignored && !hit.found()) intersectPrimitive<F>(scene, ray, shear, id, hit);
          },
          [&](Real t) { return hit.found() || ray.tMax <= t; });
      return hit.found();
    }
  }
  for (std::uint32_t id = 0; id < scene.primitiveCount && !hit.found(); ++id)
    if (id != ignored) intersectPrimitive<F>(scene, ray, shear, id, hit);
  return hit.found();
}

}  // namespace ropelight::RL_TARGET
