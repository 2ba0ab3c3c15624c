#include <oneapi/tbb/parallel_for.h>

#include <numeric>

#include "accel/bvh/tree.h"

namespace ropelight::bvh {
namespace {

constexpr std::uint32_t nowhere = 0xFFFFFFFFu;

/// Takes a node away from its parent and makes it the sibling of another.
struct Move {
  std::uint32_t node = nowhere, to = nowhere;
  float gain = 0;  ///< how much less the areas of all inner nodes add up to
};

/// Parallel reinsertion (Meister & Bittner 2018, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization"):
/// for many nodes at a time the best new place is sought; then moves are made, the largest gain first, that do not
/// touch what an earlier move has touched.
class Reinserter {
 public:
  explicit Reinserter(Tree& tree) : tree_(tree), parent_(tree.size(), 0), touched_(tree.size()) {
    for (std::uint32_t i = 0; i < tree.size(); ++i)
      if (!tree[i].isLeaf()) parent_[tree[i].left] = parent_[tree[i].right] = i;
  }

  /// Considers the nodes of largest area, which are those that rays visit most.
  void pass(double share) {
    std::vector<std::uint32_t> const nodes = largest(std::size_t(double(tree_.size()) * share));
    std::vector<Move> moves(nodes.size());
    using Range = oneapi::tbb::blocked_range<std::size_t>;
    oneapi::tbb::parallel_for(Range(0, nodes.size(), 64), [&](const Range& range) {
      std::vector<Candidate> stack;
      for (std::size_t i = range.begin(); i != range.end(); ++i) moves[i] = bestMove(nodes[i], stack);
    });
    std::erase_if(moves, [](const Move& m) { return m.to == nowhere; });
    std::sort(moves.begin(), moves.end(),
              [](const Move& a, const Move& b) { return a.gain > b.gain || (a.gain == b.gain && a.node < b.node); });
    std::fill(touched_.begin(), touched_.end(), std::uint8_t(0));
    for (const Move& m : moves)
      if (mayMake(m)) make(m);
  }

 private:
  /// A place to look at, and what taking the node out of its old and into this place's parent gains.
  struct Candidate {
    std::uint32_t node;
    float gain;
  };

  /// In the order of the tree, so that neighbours are sought together.
  std::vector<std::uint32_t> largest(std::size_t count) const {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 1; i < tree_.size(); ++i)
      if (parent_[i] != 0) nodes.push_back(i);
    if (count >= nodes.size()) return nodes;
    auto const larger = [&](std::uint32_t a, std::uint32_t b) {
      float const x = tree_[a].box.area(), y = tree_[b].box.area();
      return x > y || (x == y && a < b);
    };
    std::nth_element(nodes.begin(), nodes.begin() + std::ptrdiff_t(count), nodes.end(), larger);
    nodes.resize(count);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  std::uint32_t sibling(std::uint32_t node) const {
    const Node& p = tree_[parent_[node]];
    return p.left == node ? p.right : p.left;
  }

  /// Looks into the subtrees that hang off the way up to the root. Whatever is above x's new and old place alike keeps
  /// its box; what is above the old place alone shrinks to `shrunk`.
  Move bestMove(std::uint32_t x, std::vector<Candidate>& stack) const {
    Move best{x};
    std::uint32_t pivot = parent_[x], beside = sibling(x);
    Box shrunk = tree_[beside].box;
    float saved = tree_[pivot].box.area();
    while (true) {
      search({beside, saved}, tree_[x].box, stack, best);
      if (pivot != parent_[x]) {
        shrunk.grow(tree_[beside].box);
        saved += tree_[pivot].box.area() - shrunk.area();
      }
      if (pivot == 0) return best;
      beside = sibling(pivot);
      pivot = parent_[pivot];
    }
  }

  void search(Candidate from, const Box& box, std::vector<Candidate>& stack, Move& best) const {
    float const least = box.area();  // of a new parent, wherever it is
    stack.assign(1, from);
    while (!stack.empty()) {
      Candidate const c = stack.back();
      stack.pop_back();
      if (c.gain - least <= best.gain) continue;
      const Node& node = tree_[c.node];
      float const united = unite(node.box, box).area();
      if (c.gain - united > best.gain) {
        best.gain = c.gain - united;
        best.to = c.node;
      }
      float const below = c.gain + node.box.area() - united;
      if (node.isLeaf() || below - least <= best.gain) continue;
      stack.push_back({node.left, below});
      stack.push_back({node.right, below});
    }
  }

  bool mayMake(const Move& m) const {
    std::uint32_t const p = parent_[m.node];
    for (std::uint32_t n : {m.node, sibling(m.node), p, parent_[p], m.to, parent_[m.to]})
      if (touched_[n]) return false;
    for (std::uint32_t n = m.to; n != 0; n = parent_[n])
      if (n == m.node || n == p) return false;
    return p != 0 && m.to != sibling(m.node);
  }

  /// The old parent goes along as the new one.
  void make(const Move& m) {
    std::uint32_t const p = parent_[m.node], s = sibling(m.node), grandparent = parent_[p], above = parent_[m.to];
    for (std::uint32_t n : {m.node, s, p, grandparent, m.to, above}) touched_[n] = 1;
    replaceChild(grandparent, p, s);
    replaceChild(above == p ? grandparent : above, m.to, p);
    tree_[p].left = m.to;
    tree_[p].right = m.node;
    parent_[m.to] = parent_[m.node] = p;
    refit(grandparent);
    refit(p);
  }

  void replaceChild(std::uint32_t parent, std::uint32_t before, std::uint32_t after) {
    Node& n = tree_[parent];
    (n.left == before ? n.left : n.right) = after;
    parent_[after] = parent;
  }

  void refit(std::uint32_t node) {
    for (;; node = parent_[node]) {
      tree_[node].box = unite(tree_[tree_[node].left].box, tree_[tree_[node].right].box);
      if (node == 0) return;
    }
  }

  Tree& tree_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> touched_;
};

struct Shape {
  double area = 0;  ///< of all inner nodes
  int depth = 0;
};

void measure(const Tree& tree, std::uint32_t node, int depth, Shape& shape) {
  if (tree[node].isLeaf()) {
    shape.depth = std::max(shape.depth, depth);
    return;
  }
  shape.area += double(tree[node].box.area());
  measure(tree, tree[node].left, depth + 1, shape);
  measure(tree, tree[node].right, depth + 1, shape);
}

Shape shapeOf(const Tree& tree) {
  Shape shape;
  measure(tree, 0, 0, shape);
  return shape;
}

}  // namespace

void reinsert(Tree& tree, int passes) {
  constexpr double share = 0.1;
  if (passes <= 0 || tree.size() < 7) return;
  Tree kept = tree;
  Shape best = shapeOf(tree);
  Reinserter reinserter(tree);
  for (int i = 0; i < passes; ++i) {
    reinserter.pass(share);
    Shape const shape = shapeOf(tree);
    if (shape.depth > bvhDepthLimit || shape.area >= best.area) {
      tree = std::move(kept);
      return;
    }
    best = shape;
    if (i + 1 < passes) kept = tree;
  }
}

}  // namespace ropelight::bvh
