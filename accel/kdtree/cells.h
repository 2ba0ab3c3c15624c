#pragma once
// The kd-tree's cells as boxes, for drawing.

#include <cstddef>
#include <vector>

#include "accel/kdtree/kd_tree.h"

namespace ropelight {

struct KdCell {
  float bounds[6] = {};  ///< min x y z, max x y z
  int depth = 0;         ///< 0: the root
  bool leaf = false;
};

/// The cells of all nodes down to `depth`, level by level from the root. With `onlyDeepest`, only the nodes at `depth`
/// and the leaves above it, which together fill the root. If that makes more than `most` boxes, the deepest levels are
/// left out. Empty for a tree without nodes.
std::vector<KdCell> cellLines(const KdTree& tree, int depth, bool onlyDeepest, std::size_t most = 20000);

}  // namespace ropelight
