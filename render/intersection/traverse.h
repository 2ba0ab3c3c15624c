#pragma once
// The walks that a scene and each of its meshes share, whichever way their structures are traversed.

#include "accel/bvh/traverse.h"
#include "accel/bvh/traverse_wide.h"
#include "accel/kdtree/traverse_ropes.h"
#include "accel/kdtree/traverse_short_stack.h"
#include "render/core/features.h"

namespace ropelight::RL_TARGET {

/// By ropes, or with a short stack where F says so and `shortStack` is set. View: of a scene or of a mesh.
template <FeatureBits F, class View, class Test, class Done>
RL_HD inline void traverseTree(const View& view, const Ray& ray, Test&& test, Done&& done) {
  if constexpr ((F & feature::shortStack) != 0)
    if (view.shortStack) return traverseShortStack(view.tree, ray, test, done);
  traverseRopes(view.tree, ray, test, done);
}

template <int W, class Test, class Limit, class Visit>
RL_HD inline void traverseBvh(const BvhView<W>& bvh, const Ray& ray, Test&& test, Limit&& limit, Visit&& visit) {
  if constexpr (W == 4)
    traverseWide(bvh, ray, test, limit, visit);
  else
    traverseBinary(bvh, ray, test, limit, visit);
}

template <int W, class Test, class Limit>
RL_HD inline void traverseBvh(const BvhView<W>& bvh, const Ray& ray, Test&& test, Limit&& limit) {
  traverseBvh(bvh, ray, test, limit, [] {});
}

}  // namespace ropelight::RL_TARGET
