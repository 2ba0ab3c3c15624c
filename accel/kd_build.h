#pragma once
// Builds the kd-tree on the CPU: binned surface-area heuristic or midpoint splits (MacDonald & Booth 1990; Wald &
// Havran 2006), then ropes.

#include "accel/kd_tree.h"
#include "render/scene/flatten.h"

namespace ropelight {

struct KdConfig {
  bool midpoint = false;     ///< split at the middle of the longest axis; else SAH
  int bins = 32;             ///< candidate planes per axis for SAH
  int leafSize = 4;          ///< a node of at most this many primitives is a leaf
  int maxDepth = 0;          ///< 0: 8 + 1.3 log2(primitives)
  double traversalCost = 1;  ///< of one inner node, in units of one primitive test
  double emptyBonus = 0.2;   ///< share of the cost taken off a split that cuts off empty space

  bool operator==(const KdConfig&) const = default;
};

/// 8 + 1.3 log2(primitives), the depth that Havran (2000) found to suffice.
int automaticTreeDepth(std::uint32_t primitives);

/// An empty scene gives one empty leaf. Every leaf holds all primitives whose surface comes within the rounding error
/// of traversal of its cell.
KdTree buildKdTree(const FlatScene& scene, const KdConfig& config);

/// Connects the leaves: each rope leads to the smallest node that covers its face.
void connectRopes(KdTree& tree);

}  // namespace ropelight
