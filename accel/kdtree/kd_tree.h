#pragma once
// The kd-tree's layout: nodes in depth-first order (the low child follows its parent), leaves in a list of their own
// with their bounds and six ropes (Popov et al. 2007, "Stackless KD-Tree Traversal for High Performance GPU Ray
// Tracing").

#include <vector>

#include "render/core/span.h"

namespace ropelight {

inline constexpr std::uint32_t noRope = 0xFFFFFFFFu;

/// Inner: split plane, axis in the low two bits of `link`, high child above them. Leaf: axis 3, leaf index above it.
struct KdNode {
  float split = 0;
  std::uint32_t link = 3;

  RL_HD bool isLeaf() const { return (link & 3u) == 3u; }
  RL_HD std::uint32_t axis() const { return link & 3u; }
  RL_HD std::uint32_t target() const { return link >> 2; }
};

/// bounds: min x y z, max x y z. ropes: node across the faces −x −y −z +x +y +z, or noRope at the tree's border.
struct KdLeaf {
  float bounds[6] = {};
  std::uint32_t ropes[6] = {noRope, noRope, noRope, noRope, noRope, noRope};
  std::uint32_t first = 0;  ///< into the reference list
  std::uint32_t count = 0;
};

struct KdTreeStats {
  double seconds = 0;  ///< of the whole build
  double sahCost = 0;  ///< expected cost of a random line, in units of one primitive test
  int depth = 0;       ///< inner nodes on the longest path to a leaf
  double ropeSeconds = 0;
  double duplicates = 0;          ///< references per primitive
  std::uint32_t largestLeaf = 0;  ///< primitives
  std::uint64_t budgetHits = 0;   ///< splits not made for lack of memory
};

struct KdTree {
  std::vector<KdNode> nodes;
  std::vector<KdLeaf> leaves;
  std::vector<std::uint32_t> references;  ///< primitive ids, ascending within a leaf
  float bounds[6] = {};
  KdTreeStats stats;

  std::size_t bytes() const {
    return nodes.size() * sizeof(KdNode) + leaves.size() * sizeof(KdLeaf) + references.size() * sizeof(std::uint32_t);
  }
};

/// What kernels see of it.
struct KdTreeView {
  Span<const KdNode> nodes;
  Span<const KdLeaf> leaves;
  Span<const std::uint32_t> references;
  float bounds[6] = {};
};

}  // namespace ropelight
