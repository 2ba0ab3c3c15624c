#pragma once
// What the stages of the BVH's build hand to one another: boxes of primitives, and a binary tree over them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "accel/bvh/build.h"

namespace ropelight::bvh {

/// Bounds in single precision; the fourth components are unused, so that four fit a vector register.
struct alignas(16) Box {
  float min[4] = {unbounded, unbounded, unbounded, 0};
  float max[4] = {-unbounded, -unbounded, -unbounded, 0};

  static constexpr float unbounded = std::numeric_limits<float>::infinity();

  void grow(const Box& b) {
    for (int a = 0; a < 4; ++a) min[a] = min[a] < b.min[a] ? min[a] : b.min[a];
    for (int a = 0; a < 4; ++a) max[a] = max[a] > b.max[a] ? max[a] : b.max[a];
  }
  /// Half of the surface area; of a box that is not empty.
  float area() const {
    float const x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
    return x * (y + z) + y * z;
  }
  float center2(int axis) const { return min[axis] + max[axis]; }  ///< twice the centre
};

/// The largest float that is not above x.
inline float roundDown(double x) {
  float const f = float(x);
  return double(f) > x ? std::nextafter(f, -Box::unbounded) : f;
}

inline Box unite(Box a, const Box& b) {
  a.grow(b);
  return a;
}

/// The primitives in an order in which neighbours in the list are neighbours in space. Coordinates are multiplied by
/// 2^shift, which makes the reach about one, so that areas neither overflow nor vanish.
struct Primitives {
  std::vector<Box> box;           ///< padded by 2⁻²⁰ of the reach and rounded outward
  std::vector<std::uint32_t> id;  ///< in the scene
  int shift = 0;

  std::uint32_t size() const { return std::uint32_t(box.size()); }
};

Primitives preparePrimitives(const FlatScene& scene);

/// A leaf holds one primitive: left is `leafMark`, right the primitive's place in Primitives.
struct Node {
  Box box;
  std::uint32_t left = leafMark, right = 0;

  static constexpr std::uint32_t leafMark = 0xFFFFFFFFu;
  bool isLeaf() const { return left == leafMark; }
};

/// 2n − 1 nodes for n primitives; node 0 is the root.
using Tree = std::vector<Node>;

/// Splits from the top by the surface-area heuristic, in depth-first order, not deeper than bvhDepthLimit.
Tree split(const Primitives& primitives, const BvhConfig& config);

/// Moves subtrees to where they cost less; never makes the tree more expensive, or deeper than bvhDepthLimit.
void reinsert(Tree& tree, int passes);

/// Makes leaves of subtrees where that lowers the cost, and lays the rest out depth first.
Bvh<2> layOut(const Tree& tree, const Primitives& primitives, const BvhConfig& config);

}  // namespace ropelight::bvh
