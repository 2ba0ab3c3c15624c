#pragma once
// One primitive of a scene by its number.

#include "render/intersection/instance.h"
#include "render/intersection/scene_view.h"

namespace ropelight::RL_TARGET {

/// Triangle k of a scene. Without feature::bvh in F, the caller knows that they lie in the order of their numbers.
template <FeatureBits F>
RL_HD inline const Triangle& triangleOf(const SceneView& scene, std::uint32_t k) {
  if constexpr ((F & feature::bvh) != 0) return scene.triangles[k];
  return scene.triangles.triangles[k];
}

/// anyHit: of an instance any triangle will do.
template <FeatureBits F, bool anyHit = false>
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
  if constexpr ((F & feature::triangles) != 0) {
    if ((F & feature::instances) == 0 || k < scene.triangles.size)
      return intersect(triangleOf<F>(scene, k), shear, id, hit);
  }
  k -= scene.triangles.size;
  if constexpr ((F & feature::instances) != 0) intersect<F, anyHit>(scene.meshes, scene.instances[k], ray, hit);
}

}  // namespace ropelight::RL_TARGET
