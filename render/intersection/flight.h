#pragma once
// Surfaces at the same place: which of them a ray hits first, and which one next. Hits find the place; a short ray
// along the normal there finds who else covers it, and the numbers of their layers decide. So every structure and every
// order of the file give the same answer, and scenes without such surfaces compile none of it.

#include "render/intersection/intersect.h"
#include "render/intersection/surface.h"

namespace ropelight::RL_TARGET {

/// A ray on its way, or the surface that it hits before it gets anywhere.
struct Flight {
  Ray ray;
  Hit ahead;
};

/// Whether two primitives are one, or lie in one stack.
template <FeatureBits F>
RL_HD inline bool samePlace(const SceneView& scene, std::uint32_t a, std::uint32_t b) {
  if (a == b) return true;
  if constexpr ((F & feature::coincident) == 0) return false;
  if (scene.layers.empty() || a >= scene.layers.size || b >= scene.layers.size) return false;
  return scene.layers[a].sharesStack(scene.layers[b]);
}

namespace stack {

RL_HD inline Layer layerOf(const SceneView& scene, std::uint32_t primitive) {
  return primitive < scene.layers.size ? scene.layers[primitive] : Layer{};
}

/// Whether w leads to the front of the stack that the surface lies in.
RL_HD inline bool towardsFront(const Surface& s, const Layer& layer, Vec3 w) {
  return (dot(s.n, w) > 0) != layer.flipped();
}

/// Calls test(id) for what the ray may hit within its tMax.
template <FeatureBits F, class Test>
RL_HD inline void forEachNear(const SceneView& scene, const Ray& ray, Test&& test) {
  if constexpr ((F & feature::bvh) != 0)
    if (!scene.bvh.nodes.empty())
      return traverseBvh(
          scene.bvh, ray, [&](std::uint32_t item) { test(scene.bvh.items[item]); }, [&] { return ray.tMax; });
  if constexpr ((F & feature::tree) != 0)
    if (!scene.tree.nodes.empty()) return traverseTree<F>(scene, ray, test, [&](Real t) { return ray.tMax <= t; });
  for (std::uint32_t id = 0; id < scene.primitiveCount; ++id) test(id);
}

/// The surface of the stack at s whose number, as seen from the front or the back, is the highest below that of s, or
/// the lowest of all. Its t is 0; none is found where there is no such surface.
template <FeatureBits F>
RL_HD inline Hit search(const SceneView& scene, const Surface& s, const Layer& at, bool front, bool lowest) {
  constexpr FeatureBits shapes = F & ~(feature::tree | feature::shortStack | feature::instances);
  Ray const probe{s.p - s.n * Real(at.depth), s.n, 2 * Real(at.depth)};
  RayShear const shear(probe);
  std::uint32_t const limit = front ? at.fromFront : at.fromBack;
  std::uint32_t best = limit;
  Hit found;
  forEachNear<F>(scene, probe, [&](std::uint32_t id) {
    Layer const layer = layerOf(scene, id);
    if (!layer.sharesStack(at)) return;
    std::uint32_t const number = front ? layer.fromFront : layer.fromBack;
    if (number >= limit || (found.found() && (lowest ? number >= best : number <= best))) return;
    Hit hit;
    hit.t = probe.tMax;
    intersectPrimitive<shapes>(scene, probe, shear, id, hit);
    if (!hit.found()) return;
    found = hit;
    best = number;
  });
  found.t = 0;
  return found;
}

RL_HD inline void widen(Surface& s, const Layer& layer) {
  for (int a = 0; a < 3; ++a) s.error[a] = maxOf(s.error[a], Real(layer.depth));
}

/// What lies before the surface for somebody whom w leads to.
template <FeatureBits F>
RL_HD inline Hit before(const SceneView& scene, const Surface& s, Vec3 w) {
  Layer const at = layerOf(scene, s.primitive);
  return at.stacked() ? search<F>(scene, s, at, towardsFront(s, at, w), false) : Hit{};
}

}  // namespace stack

/// The surface at a hit, where several lie at the same place the one that the ray hits first.
template <FeatureBits F>
RL_HD inline Surface surfaceMet(const SceneView& scene, const Ray& ray, const Hit& hit) {
  Surface s = surfaceAt<F>(scene, ray, hit);
  if constexpr ((F & feature::coincident) != 0) {
    Layer const at = stack::layerOf(scene, s.primitive);
    if (!at.stacked()) return s;
    Hit const first = stack::search<F>(scene, s, at, stack::towardsFront(s, at, -ray.direction), true);
    if (first.found()) s = surfaceAt<F>(scene, Ray{s.p, s.n}, first);
    stack::widen(s, at);
  }
  return s;
}

/// Follows a flight to the next surface; false where it hits none.
template <FeatureBits F>
RL_HD inline bool meet(const SceneView& scene, const Flight& flight, Surface& out) {
  if constexpr ((F & feature::coincident) != 0) {
    if (flight.ahead.found()) {
      out = surfaceAt<F>(scene, flight.ray, flight.ahead);
      stack::widen(out, stack::layerOf(scene, out.primitive));
      return true;
    }
  }
  Hit const hit = closestHit<F>(scene, flight.ray);
  if (!hit.found()) return false;
  out = surfaceMet<F>(scene, flight.ray, hit);
  return true;
}

/// Leaves a surface along w, clear of it on w's side, or as far as the next surface at the same place.
template <FeatureBits F>
RL_HD inline Flight depart(const SceneView& scene, const Surface& s, Vec3 w) {
  Flight flight{Ray{offsetRayOrigin(s.p, s.error, s.n, w), w, infinity}, Hit{}};
  if constexpr ((F & feature::coincident) != 0) flight.ahead = stack::before<F>(scene, s, w);
  return flight;
}

/// Whether another opaque surface at the same place hides the one that a flight has just left.
template <FeatureBits F>
RL_HD inline bool hiddenAtStart(const SceneView& scene, const Flight& flight) {
  if constexpr ((F & feature::coincident) == 0) return false;
  return flight.ahead.found() && stack::layerOf(scene, flight.ahead.primitive).opaque();
}

}  // namespace ropelight::RL_TARGET
