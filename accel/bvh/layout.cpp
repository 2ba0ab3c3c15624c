#include <oneapi/tbb/parallel_invoke.h>

#include <cmath>

#include "accel/bvh/tree.h"

namespace ropelight::bvh {
namespace {

constexpr std::uint32_t parallelFrom = 4096;

/// What becomes of a subtree; inner = 0 where it becomes one leaf.
struct Summary {
  double cost = 0;  ///< in areas of Box
  std::uint32_t items = 1;
  std::uint32_t inner = 0;
};

template <class A, class B>
void both(bool parallel, const A& a, const B& b) {
  if (parallel) return oneapi::tbb::parallel_invoke(a, b);
  a();
  b();
}

class Layout {
 public:
  Layout(const Tree& tree, const Primitives& primitives, const BvhConfig& config)
      : tree_(tree), primitives_(primitives), config_(config), summary_(tree.size()) {
    leafSize_ = std::uint32_t(std::clamp(config.leafSize, 1, int(BvhChild::maxItems)));
    scale_ = std::ldexp(1.0, -primitives.shift);
  }

  Bvh<2> run() {
    if (tree_[0].isLeaf()) return single();
    summarise(0, 0);
    out_.nodes.resize(summary_[0].inner);
    out_.items.resize(summary_[0].items);
    out_.stats.depth = emit(0, 0, 0);
    out_.stats.leaves = out_.nodes.size() + 1;
    double const area = double(tree_[0].box.area());
    out_.stats.sahCost = area > 0 ? summary_[0].cost / area : double(out_.items.size());
    return std::move(out_);
  }

 private:
  Bvh<2> single() {
    out_.nodes.resize(1);
    for (int k = 0; k < 2; ++k) setChild(out_.nodes[0], k, tree_[0].box, BvhChild::leaf(0, 1));
    out_.items = {primitives_.id[tree_[0].right]};
    out_.stats = {.seconds = 0, .sahCost = config_.traversalCost + 2, .depth = 1, .leaves = 2};
    return std::move(out_);
  }

  /// A subtree becomes a leaf where that costs no more; the root stays.
  void summarise(std::uint32_t index, int depth) {
    const Node& node = tree_[index];
    Summary& out = summary_[index];
    out.cost = double(node.box.area());
    if (node.isLeaf()) return;
    both(
        depth < 8, [&] { summarise(node.left, depth + 1); }, [&] { summarise(node.right, depth + 1); });
    const Summary &a = summary_[node.left], &b = summary_[node.right];
    double const leaf = out.cost * (a.items + b.items), inner = out.cost * config_.traversalCost + a.cost + b.cost;
    out.items = a.items + b.items;
    bool const collapse = out.items <= leafSize_ && leaf <= inner && index != 0;
    out.cost = collapse ? leaf : inner;
    out.inner = collapse ? 0 : a.inner + b.inner + 1;
  }

  /// Returns the depth.
  int emit(std::uint32_t index, std::uint32_t to, std::uint32_t item) {
    const Node& node = tree_[index];
    const Summary& first = summary_[node.left];
    int depth[2];
    both(
        summary_[index].items >= parallelFrom, [&] { depth[0] = emitChild(node.left, to, 0, to + 1, item); },
        [&] { depth[1] = emitChild(node.right, to, 1, to + 1 + first.inner, item + first.items); });
    return 1 + std::max(depth[0], depth[1]);
  }

  int emitChild(std::uint32_t index, std::uint32_t parent, int k, std::uint32_t to, std::uint32_t item) {
    const Summary& s = summary_[index];
    bool const leaf = s.inner == 0;
    setChild(out_.nodes[parent], k, tree_[index].box, leaf ? BvhChild::leaf(item, s.items) : BvhChild::inner(to));
    if (!leaf) return emit(index, to, item);
    std::uint32_t* const end = gather(index, out_.items.data() + item);
    std::sort(out_.items.data() + item, end);
    return 0;
  }

  std::uint32_t* gather(std::uint32_t index, std::uint32_t* to) const {
    const Node& node = tree_[index];
    if (!node.isLeaf()) return gather(node.right, gather(node.left, to));
    *to = primitives_.id[node.right];
    return to + 1;
  }

  /// Rounds outward once more where the scene's own scale cannot hold a bound exactly.
  void setChild(BvhNode<2>& node, int k, const Box& box, BvhChild child) const {
    for (int a = 0; a < 3; ++a) {
      node.min[a][k] = roundDown(double(box.min[a]) * scale_);
      node.max[a][k] = -roundDown(-double(box.max[a]) * scale_);
    }
    node.child[k] = child;
  }

  const Tree& tree_;
  const Primitives& primitives_;
  const BvhConfig& config_;
  std::vector<Summary> summary_;
  Bvh<2> out_;
  std::uint32_t leafSize_;
  double scale_;
};

}  // namespace

Bvh<2> layOut(const Tree& tree, const Primitives& primitives, const BvhConfig& config) {
  return Layout(tree, primitives, config).run();
}

}  // namespace ropelight::bvh
