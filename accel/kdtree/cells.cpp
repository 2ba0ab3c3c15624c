#include "accel/kdtree/cells.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ropelight {
namespace {

struct Node {
  std::uint32_t index = 0;
  KdCell cell;
};

/// The two halves of an inner node's cell.
std::pair<Node, Node> childrenOf(const KdTree& tree, const Node& parent) {
  const KdNode& node = tree.nodes[parent.index];
  Node low{parent.index + 1, parent.cell}, high{node.target(), parent.cell};
  low.cell.bounds[node.axis() + 3] = high.cell.bounds[node.axis()] = node.split;
  for (Node* child : {&low, &high}) {
    child->cell.depth = parent.cell.depth + 1;
    child->cell.leaf = tree.nodes[child->index].isLeaf();
  }
  return {low, high};
}

/// The level below; leaves have none.
std::vector<Node> levelBelow(const KdTree& tree, const std::vector<Node>& level) {
  std::vector<Node> below;
  for (const Node& node : level) {
    if (node.cell.leaf) continue;
    auto const [low, high] = childrenOf(tree, node);
    below.push_back(low);
    below.push_back(high);
  }
  return below;
}

}  // namespace

std::vector<KdCell> cellLines(const KdTree& tree, int depth, bool onlyDeepest, std::size_t most) {
  std::vector<KdCell> cells;
  if (tree.nodes.empty() || most == 0) return cells;
  Node root;
  std::copy_n(tree.bounds, 6, root.cell.bounds);
  root.cell.leaf = tree.nodes[0].isLeaf();
  cells.push_back(root.cell);
  std::vector<Node> level{root};
  for (int d = 0; d < depth; ++d) {
    level = levelBelow(tree, level);
    // Every pair of children takes the place of its parent where only the deepest are wanted.
    std::size_t const more = onlyDeepest ? level.size() / 2 : level.size();
    if (level.empty() || cells.size() + more > most) break;
    if (onlyDeepest) std::erase_if(cells, [](const KdCell& c) { return !c.leaf; });
    for (const Node& node : level) cells.push_back(node.cell);
  }
  return cells;
}

}  // namespace ropelight
