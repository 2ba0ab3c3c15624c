#pragma once
// The kd-tree's cells as boxes, to be looked at.

#include <cstddef>
#include <vector>

#include "accel/kdtree/kd_tree.h"

namespace ropelight {

struct KdCell {
  float bounds[6] = {};  ///< min x y z, max x y z
  int depth = 0;         ///< 0: the root
  bool leaf = false;
};

/// The cells of all nodes down to `depth`, the root first and level by level; with `onlyDeepest` those alone that no
/// other of them divides: the nodes at `depth` and the leaves above, which together fill the root. Where they would be
/// more than `most` boxes, as many whole levels as are not. Empty for a tree without nodes.
std::vector<KdCell> cellLines(const KdTree& tree, int depth, bool onlyDeepest, std::size_t most = 20000);

}  // namespace ropelight
