#pragma once
// The layout of the bounding-volume hierarchy (BVH): every inner node holds the bounds of its W children, leaves are
// runs of items.

#include <vector>

#include "render/core/span.h"

namespace ropelight {

/// Where a child is: an inner node, or a run of 1 to 15 items.
struct BvhChild {
  static constexpr std::uint32_t maxItems = 15;

  std::uint32_t bits;  ///< inner: node index << 4; leaf: first item << 4 | number of items; 0: no child

  static constexpr BvhChild inner(std::uint32_t node) { return {node << 4}; }
  static constexpr BvhChild leaf(std::uint32_t first, std::uint32_t count) { return {first << 4 | count}; }
  RL_HD bool none() const { return bits == 0; }  ///< the root is nobody's child
  RL_HD bool isLeaf() const { return (bits & 15u) != 0; }
  RL_HD std::uint32_t index() const { return bits >> 4; }  ///< of the node or of the first item
  RL_HD std::uint32_t count() const { return bits & 15u; }
};

/// Bounds by axis, then child; a child that is not there has min = +∞ and max = −∞. Of two children both are there.
template <int W>
struct alignas(W == 4 ? 64 : 16) BvhNode {
  float min[3][W];
  float max[3][W];
  BvhChild child[W];
};

struct BvhStats {
  double seconds = 0;
  double sahCost = 0;  ///< expected cost of a random line, in units of one primitive test
  int depth = 0;       ///< inner nodes on the longest path to a leaf
  std::uint64_t leaves = 0;
};

/// Node 0 is the root. items: primitive ids, each at least once; ascending within a leaf.
template <int W>
struct Bvh {
  std::vector<BvhNode<W>> nodes;
  std::vector<std::uint32_t> items;
  BvhStats stats;

  std::size_t bytes() const { return nodes.size() * sizeof(BvhNode<W>) + items.size() * sizeof(std::uint32_t); }
};

/// What kernels see of it.
template <int W>
struct BvhView {
  Span<const BvhNode<W>> nodes;
  Span<const std::uint32_t> items;
};

/// No path from the root to a leaf has more inner nodes than this, whatever the scene.
inline constexpr int bvhDepthLimit = 60;

}  // namespace ropelight
