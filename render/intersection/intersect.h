#pragma once
// Closest and any hit of a scene: through the structure that there is, else by testing every primitive.

#include "render/intersection/two_level.h"

namespace ropelight::RL_TARGET {

/// The primitive of one item of the hierarchy; `ignored` is not tested.
template <FeatureBits F, bool anyHit = false>
RL_HD inline void intersectItem(const SceneView& scene, const Ray& ray, const RayShear& shear, std::uint32_t item,
                                Hit& hit, std::uint32_t ignored = noPrimitive) {
  if constexpr ((F & (feature::triangles | feature::instances)) != 0) {
    Triangle const triangle = scene.bvhTriangles[item];  // as a whole: a GPU loads it in three words
    std::uint32_t const id = triangle.id;
    if (id == ignored) return;
    if constexpr ((F & (feature::quads | feature::spheres | feature::instances)) != 0) {
      constexpr FeatureBits others = F & ~feature::triangles;
      if (id - (scene.quads.size + scene.spheres.size) >= scene.triangles.size)  // wraps for quads and spheres
        return intersectPrimitive<others, anyHit>(scene, ray, shear, id, hit);
    }
    intersect(triangle, shear, id, hit);
  } else {
    std::uint32_t const id = scene.bvh.items[item];
    if (id != ignored) intersectPrimitive<F>(scene, ray, shear, id, hit);
  }
}

/// Every primitive, kind by kind. The reference that every other structure must equal. With feature::bvh the triangles
/// may lie in the order of a BVH.
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
    for (std::uint32_t k = 0; k < scene.triangles.size; ++k) intersect(triangleOf<F>(scene, k), shear, id++, hit);
  if constexpr ((F & feature::instances) != 0)
    for (const Instance& instance : scene.instances) intersect<FeatureBits(0), false>(scene.meshes, instance, ray, hit);
  return hit;
}

template <FeatureBits F>
RL_HD inline bool occludedBruteForce(const SceneView& scene, const Ray& ray, std::uint32_t ignored) {
  constexpr FeatureBits shapes = F & ~feature::tree;
  RayShear const shear(ray);
  Hit hit;
  hit.t = ray.tMax;
  for (std::uint32_t id = 0; id < scene.primitiveCount && !hit.found(); ++id)
    if (id != ignored) intersectPrimitive<shapes, true>(scene, ray, shear, id, hit);
  return hit.found();
}

/// A kd-tree holds an instance in many cells: it is not met again right after it was.
template <FeatureBits F>
class LastInstance {
 public:
  RL_HD explicit LastInstance(const SceneView& scene) : first_(scene.primitiveCount - scene.instances.size) {}

  RL_HD bool again(std::uint32_t id) {
    if constexpr ((F & feature::instances) == 0) return false;
    if (id < first_) return false;
    bool const same = id == last_;
    last_ = id;
    return same;
  }

 private:
  std::uint32_t first_, last_ = noPrimitive;
};

template <FeatureBits F>
RL_HD inline Hit closestHitTree(const SceneView& scene, const Ray& ray) {
  constexpr FeatureBits shapes = F & ~feature::bvh;
  Hit hit;
  hit.t = ray.tMax;
  RayShear const shear(ray);
  LastInstance<F> last(scene);
  traverseTree<F>(
      scene, ray,
      [&](std::uint32_t id) {
        if (!last.again(id)) intersectPrimitive<shapes>(scene, ray, shear, id, hit);
      },
      [&](Real t) { return hit.t <= t; });
  return hit;
}

template <FeatureBits F>
RL_HD inline bool occludedTree(const SceneView& scene, const Ray& ray, std::uint32_t ignored) {
  constexpr FeatureBits shapes = F & ~feature::bvh;
  RayShear const shear(ray);
  Hit hit;
  hit.t = ray.tMax;
  LastInstance<F> last(scene);
  traverseTree<F>(
      scene, ray,
      [&](std::uint32_t id) {
        if (id != ignored && !hit.found() && !last.again(id))
          intersectPrimitive<shapes, true>(scene, ray, shear, id, hit);
      },
      [&](Real t) { return hit.found() || ray.tMax <= t; });
  return hit.found();
}

template <FeatureBits F, int W>
RL_HD inline Hit closestHitBvh(const SceneView& scene, const BvhView<W>& bvh, const Ray& ray) {
  if constexpr (W == 2 && bvhWidth == 2 && (F & feature::instances) != 0)
    return TwoLevelTraversal<F, false>(scene, ray, noPrimitive).run();
  Hit hit;
  hit.t = ray.tMax;
  RayShear const shear(ray);
  traverseBvh(
      bvh, ray, [&](std::uint32_t item) { intersectItem<F>(scene, ray, shear, item, hit); }, [&] { return hit.t; });
  return hit;
}

template <FeatureBits F, int W>
RL_HD inline bool occludedBvh(const SceneView& scene, const BvhView<W>& bvh, const Ray& ray, std::uint32_t ignored) {
  if constexpr (W == 2 && bvhWidth == 2 && (F & feature::instances) != 0)
    return TwoLevelTraversal<F, true>(scene, ray, ignored).run().found();
  Hit hit;
  hit.t = ray.tMax;
  RayShear const shear(ray);
  traverseBvh(
      bvh, ray, [&](std::uint32_t item) { intersectItem<F, true>(scene, ray, shear, item, hit, ignored); },
      [&] { return hit.found() ? Real(-1) : hit.t; });
  return hit.found();
}

template <FeatureBits F>
RL_HD inline Hit closestHit(const SceneView& scene, const Ray& ray) {
  if constexpr ((F & feature::bvh) != 0)
    if (!scene.bvh.nodes.empty()) return closestHitBvh<F>(scene, scene.bvh, ray);
  if constexpr ((F & feature::tree) != 0)
    if (!scene.tree.nodes.empty()) return closestHitTree<F>(scene, ray);
  return closestHitBruteForce<F & ~feature::bvh>(scene, ray);  // no BVH, so that triangles lie by number
}

/// Whether anything but `ignored` lies in (0, tMax]. A light's own primitive is ignored: it is convex, so that it never
/// stands between its visible side and a point that sees it.
template <FeatureBits F>
RL_HD inline bool occluded(const SceneView& scene, const Ray& ray, std::uint32_t ignored) {
  if constexpr ((F & feature::bvh) != 0)
    if (!scene.bvh.nodes.empty()) return occludedBvh<F>(scene, scene.bvh, ray, ignored);
  if constexpr ((F & feature::tree) != 0)
    if (!scene.tree.nodes.empty()) return occludedTree<F>(scene, ray, ignored);
  return occludedBruteForce<F & ~feature::bvh>(scene, ray, ignored);
}

}  // namespace ropelight::RL_TARGET
