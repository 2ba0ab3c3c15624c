#pragma once
// The top of a kd-tree as a heap, small enough for shared memory: node i has the children 2i + 1 and 2i + 2; a node of
// axis 3 leads into the tree itself.

#include "accel/kdtree/traverse_ropes.h"

namespace ropelight {

/// 1023 entries are 8 KiB. Nodes below a leaf of the tree are not used.
inline constexpr int kdTopLevels = 9;

inline std::vector<KdNode> kdTop(const KdTree& tree) {
  std::uint32_t const inner = (1u << kdTopLevels) - 1;
  std::vector<KdNode> top(2 * inner + 1);
  std::vector<std::uint32_t> nodes(top.size(), 0);  // of the tree, by entry
  for (std::uint32_t i = 0; i < top.size(); ++i) {
    KdNode const n = tree.nodes[nodes[i]];
    top[i] = KdNode{0, nodes[i] << 2 | 3u};
    if (n.isLeaf() || i >= inner || (i > 0 && nodes[i] == 0)) continue;
    top[i] = n;
    nodes[2 * i + 1] = nodes[i] + 1;
    nodes[2 * i + 2] = n.target();
  }
  return top;
}

}  // namespace ropelight

namespace ropelight::RL_TARGET {

/// The node of the tree below which the ray is at parameter t.
RL_HD inline std::uint32_t descendTop(const KdNode* top, const RayPlanes& planes, Real t) {
  std::uint32_t i = 0;
  KdNode n = top[0];
  while (!n.isLeaf()) {
    i = 2 * i + (planes.below(n, t) ? 1 : 2);
    n = top[i];
  }
  return n.target();
}

}  // namespace ropelight::RL_TARGET
