#pragma once
// Builds the kd-tree on the CPU: by the surface-area heuristic over bins or over every plane, or by midpoint splits
// (MacDonald & Booth 1990; Wald & Havran 2006), then ropes.

#include <tuple>

#include "accel/kdtree/kd_tree.h"
#include "render/flat/flat_scene.h"

namespace ropelight {

enum class KdSplit {
  sah,       ///< the surface-area heuristic over evenly spaced planes
  sweep,     ///< the same over every plane at which a primitive begins or ends
  midpoint,  ///< the middle of the longest axis
};

struct KdConfig {
  KdSplit split = KdSplit::sah;
  bool clip = true;          ///< cut triangles and quads to the cells that they are counted in; else only their bounds
  int bins = 32;             ///< of sah, per axis
  int leafSize = 4;          ///< a node of at most this many primitives is a leaf
  int maxDepth = 0;          ///< 0: automaticTreeDepth
  double traversalCost = 1;  ///< of one inner node, in units of one primitive test
  double emptyBonus = 0.2;   ///< share of the cost taken off a split that cuts off empty space
  int badSplits = 1;         ///< splits in a row that may bring no gain by themselves (Havran 2000)
  int threads = 0;           ///< 0: all cores; the tree is the same for any number

  /// All that the tree depends on.
  auto shape() const { return std::tuple(split, clip, bins, leafSize, maxDepth, traversalCost, emptyBonus, badSplits); }
  bool operator==(const KdConfig& other) const { return shape() == other.shape(); }
};

/// 8 + 1.3 log2(primitives), the depth that Havran (2000) found to suffice.
int automaticTreeDepth(std::uint32_t primitives);

/// The most leaves, and the most references, of a tree: 64 + 16 per primitive, at most 2²⁹. Subtrees share it in
/// proportion to their primitives, and a node whose split would exceed its share becomes a leaf.
std::uint64_t kdTreeBudget(std::uint32_t primitives);

/// An empty scene gives one empty leaf. Every leaf holds all primitives whose surface comes within the rounding error
/// of traversal of its cell. Takes O(budget · depth) time; memory while building is at most 350 bytes per unit of the
/// budget, in practice about 300 bytes per primitive. Where subtrees cost more than a leaf with their primitives would,
/// they become one, but not with KdSplit::midpoint.
KdTree buildKdTree(const FlatScene& scene, const KdConfig& config);

/// Connects the leaves: each rope leads to the smallest node that covers its face.
void connectRopes(KdTree& tree);

}  // namespace ropelight
