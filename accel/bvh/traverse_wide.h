#pragma once
// Traversal of the BVH with four children per node, nearest first. The loops over the children are written so that a
// compiler makes vectors of four of them.

#include "accel/bvh/bvh.h"
#include "render/core/ray.h"

// GCC would unroll a loop of four before it looks for vectors, and then finds none.
#if defined(__GNUC__) && !defined(__clang__) && !RL_CUDA_TARGET
#define RL_VECTOR_LOOP _Pragma("GCC unroll 1")
#else
#define RL_VECTOR_LOOP
#endif

namespace ropelight::RL_TARGET {

/// A ray as the slab test wants it. Components close to zero are replaced by 2⁻⁶⁰ of the largest, so that no 0·∞
/// arises; on its way through the scene that moves the ray by less than the bounds are padded. Planes are taken
/// relative to the origin before they are scaled: the three roundings move a plane by 3·2⁻²⁴ of its distance.
struct WideSlabs {
  Vec3 origin, inverse;
  bool backward[3];

  RL_HD explicit WideSlabs(const Ray& ray) : origin(ray.origin) {
    Real const least = maxOf(maxAbs(ray.direction) * Real(0x1p-60), 4 * std::numeric_limits<Real>::min());
    for (int a = 0; a < 3; ++a) {
      Real const d = ray.direction[a];
      inverse[a] = 1 / (abs(d) < least ? copysign(least, d) : d);
      backward[a] = inverse[a] < 0;
    }
  }

  RL_HD Real at(int axis, float plane) const { return (Real(plane) - origin[axis]) * inverse[axis]; }
};

/// Where a ray enters and leaves each child; it misses those that it enters after it leaves.
struct WideClip {
  alignas(16) Real enter[4];
  alignas(16) Real leave[4];

  RL_HD WideClip(const BvhNode<4>& node, const WideSlabs& ray, Real limit) {
    const float* const x0 = ray.backward[0] ? node.max[0] : node.min[0];
    const float* const x1 = ray.backward[0] ? node.min[0] : node.max[0];
    const float* const y0 = ray.backward[1] ? node.max[1] : node.min[1];
    const float* const y1 = ray.backward[1] ? node.min[1] : node.max[1];
    const float* const z0 = ray.backward[2] ? node.max[2] : node.min[2];
    const float* const z1 = ray.backward[2] ? node.min[2] : node.max[2];
    RL_VECTOR_LOOP
    for (int k = 0; k < 4; ++k) {
      enter[k] = maxOf(maxOf(ray.at(0, x0[k]), ray.at(1, y0[k])), maxOf(ray.at(2, z0[k]), Real(0)));
      leave[k] = minOf(minOf(ray.at(0, x1[k]), ray.at(1, y1[k])), minOf(ray.at(2, z1[k]), limit));
    }
  }
};

/// What is still to be visited, the nearest on top.
class WideStack {
 public:
  RL_HD bool empty() const { return size_ == 0; }

  /// Below all that were pushed since `base` and are nearer.
  RL_HD void insert(int base, BvhChild child, Real enter) {
    int at = size_++;
    for (; at > base && entries_[at - 1].enter < enter; --at) entries_[at] = entries_[at - 1];
    entries_[at] = {child, enter};
  }

  /// The nearest that is entered before the limit; false where there is none.
  RL_HD bool pop(Real limit, BvhChild& child) {
    while (size_ > 0) {
      const Entry& top = entries_[--size_];
      child = top.child;
      if (top.enter <= limit) return true;
    }
    return false;
  }

  RL_HD int size() const { return size_; }

 private:
  struct Entry {
    BvhChild child;
    Real enter;
  };
  Entry entries_[3 * bvhDepthLimit + 2];
  int size_ = 0;
};

/// Calls test(item) for the items of every leaf that the ray enters before limit(), which test may lower; a negative
/// limit ends the walk. Calls visit() for every inner node.
template <class Test, class Limit, class Visit>
RL_HD void traverseWide(const BvhView<4>& bvh, const Ray& ray, Test&& test, Limit&& limit, Visit&& visit) {
  WideSlabs const slabs(ray);
  WideStack stack;
  BvhChild next = BvhChild::inner(0);
  do {
    if (next.isLeaf()) {
      for (std::uint32_t k = next.index(), end = k + next.count(); k < end; ++k) test(k);
      continue;
    }
    visit();
    const BvhNode<4>& node = bvh.nodes[next.index()];
    WideClip const clip(node, slabs, limit());
    int const base = stack.size();
    for (int k = 0; k < 4; ++k)
      if (!node.child[k].none() && clip.enter[k] <= clip.leave[k]) stack.insert(base, node.child[k], clip.enter[k]);
  } while (stack.pop(limit(), next));
}

}  // namespace ropelight::RL_TARGET
