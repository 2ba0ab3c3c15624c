#pragma once
// Traversal of the binary BVH, near child first, with a stack that remembers where each node is entered.

#include "accel/bvh/bvh.h"
#include "render/core/ray.h"

namespace ropelight::RL_TARGET {

/// The lesser and the greater of two numbers; where one is NaN, on the device, the other.
RL_HD inline Real lesser(Real a, Real b) {
#if RL_DEVICE_CODE
  return ::fmin(a, b);
#else
  return a < b ? a : b;
#endif
}
RL_HD inline Real greater(Real a, Real b) {
#if RL_DEVICE_CODE
  return ::fmax(a, b);
#else
  return a > b ? a : b;
#endif
}

/// A ray as slab tests want it: the parameter of a plane is plane·inverse + offset, one multiply-add. Components close
/// to zero are replaced by 2⁻⁴⁰ of the largest, so that nothing is infinite: within the scene that moves the ray less
/// than the bounds are padded. The same pad covers the rounding of `offset` for origins within the scene's reach.
struct SlabRay {
  Vec3 inverse, offset;

  RL_HD explicit SlabRay(const Ray& ray) {
    Real const least = maxOf(maxAbs(ray.direction) * Real(0x1p-40), 4 * std::numeric_limits<Real>::min());
    for (int a = 0; a < 3; ++a) {
      Real const d = ray.direction[a];
      inverse[a] = 1 / (abs(d) < least ? copysign(least, d) : d);
      offset[a] = -ray.origin[a] * inverse[a];
    }
  }
};

/// Where a ray is inside a box: from near to far, empty where near > far.
struct Slab {
  Real near, far;
};

template <int W>
RL_HD inline Slab clip(const BvhNode<W>& node, int child, const SlabRay& ray, Real limit) {
  Real const x0 = mulAdd(node.min[0][child], ray.inverse.x, ray.offset.x);
  Real const x1 = mulAdd(node.max[0][child], ray.inverse.x, ray.offset.x);
  Real const y0 = mulAdd(node.min[1][child], ray.inverse.y, ray.offset.y);
  Real const y1 = mulAdd(node.max[1][child], ray.inverse.y, ray.offset.y);
  Real const z0 = mulAdd(node.min[2][child], ray.inverse.z, ray.offset.z);
  Real const z1 = mulAdd(node.max[2][child], ray.inverse.z, ray.offset.z);
  return {greater(greater(lesser(x0, x1), lesser(y0, y1)), greater(lesser(z0, z1), Real(0))),
          lesser(lesser(greater(x0, x1), greater(y0, y1)), lesser(greater(z0, z1), limit))};
}

/// What a walk still has to visit. Kept apart from BvhWalk, so that the walk itself can live in registers.
struct BvhStack {
  struct alignas(8) Entry {
    BvhChild child;
    Real near;
  };
  Entry entries[bvhDepthLimit + 2];
};

/// One ray's walk through a binary BVH, leaf by leaf. limit: hits farther than this are of no interest.
class BvhWalk {
 public:
  RL_HD explicit BvhWalk(const Ray& ray) : slabs_(ray), next_(BvhChild::inner(0)) {}

  /// Descends to the next leaf that the ray enters; false where there is none. Calls visit() for every node visited.
  template <class Visit>
  RL_HD bool advance(const BvhView<2>& bvh, BvhStack& stack, Real limit, Visit&& visit) {
    while (!next_.isLeaf()) {
      visit();
      BvhNode<2> const node = bvh.nodes[next_.index()];
      Slab const a = clip(node, 0, slabs_, limit), b = clip(node, 1, slabs_, limit);
      bool const meetsA = a.near <= a.far, meetsB = b.near <= b.far;
      if (meetsA && meetsB) {
        bool const swap = b.near < a.near;
        next_ = swap ? node.child[1] : node.child[0];
        stack.entries[size_++] = {swap ? node.child[0] : node.child[1], swap ? a.near : b.near};
      } else if (meetsA || meetsB) {
        next_ = meetsA ? node.child[0] : node.child[1];
      } else if (!pop(stack, limit)) {
        return false;
      }
    }
    return true;
  }

  RL_HD bool advance(const BvhView<2>& bvh, BvhStack& stack, Real limit) {
    return advance(bvh, stack, limit, [] {});
  }

  RL_HD BvhChild leaf() const { return next_; }

  /// Takes the nearest node left that is entered before the limit; false where there is none.
  RL_HD bool pop(const BvhStack& stack, Real limit) {
    while (size_ > 0) {
      BvhStack::Entry const e = stack.entries[--size_];
      next_ = e.child;
      if (e.near <= limit) return true;
    }
    return false;
  }

 private:
  SlabRay slabs_;
  BvhChild next_;
  int size_ = 0;
};

/// Calls test(item) for the items of every leaf that the ray enters before limit(), which test may lower; a negative
/// limit ends the walk. Calls visit() for every inner node.
template <class Test, class Limit, class Visit>
RL_HD void traverseBinary(const BvhView<2>& bvh, const Ray& ray, Test&& test, Limit&& limit, Visit&& visit) {
  BvhStack stack;
  BvhWalk walk(ray);
  while (walk.advance(bvh, stack, limit(), visit)) {
    BvhChild const leaf = walk.leaf();
    for (std::uint32_t k = leaf.index(), end = k + leaf.count(); k < end; ++k) test(k);
    if (!walk.pop(stack, limit())) return;
  }
}

}  // namespace ropelight::RL_TARGET
