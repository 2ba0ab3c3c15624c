#include <oneapi/tbb/parallel_invoke.h>

#include <bit>

#include "accel/bvh/bins.h"

namespace ropelight::bvh {
namespace {

constexpr std::uint32_t spawnFrom = 2048;  ///< primitives of a node whose halves are built at the same time
constexpr std::uint32_t sweepFrom = 32;    ///< nodes of that many primitives are swept in any case

class Splitter {
 public:
  Splitter(const Primitives& primitives, const BvhConfig& config)
      : primitives_(primitives), config_(config), lists_(primitives), tree_(2 * std::size_t(primitives.size()) - 1) {}

  Tree run() {
    if (config_.sweep) lists_.sortAll();
    for (const Box& b : primitives_.box) tree_[0].box.grow(b);
    build(0, 0, primitives_.size(), 0, config_.sweep);
    return std::move(tree_);
  }

 private:
  /// A subtree of n primitives has 2n − 1 nodes, so that every node's place is known before it is built.
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth, bool sorted) {
    std::uint32_t const count = end - begin;
    if (count == 1) {
      tree_[node].right = lists_.list(0)[begin];
      return;
    }
    if (!sorted && (count <= sweepFrom || mustHalve(count, depth))) {
      lists_.sort(begin, end);
      sorted = true;
    }
    Box halves[2];
    std::uint32_t const middle = divide(node, begin, end, depth, sorted, halves);
    bool const swap = halves[1].area() > halves[0].area();
    std::uint32_t const first = swap ? end - middle : middle - begin;
    tree_[node].left = node + 1;
    tree_[node].right = node + 2 * first;
    std::uint32_t const low = swap ? tree_[node].right : tree_[node].left;
    std::uint32_t const high = swap ? tree_[node].left : tree_[node].right;
    tree_[low].box = halves[0];
    tree_[high].box = halves[1];
    both(
        count, [&] { build(low, begin, middle, depth + 1, sorted); },
        [&] { build(high, middle, end, depth + 1, sorted); });
  }

  template <class A, class B>
  static void both(std::uint32_t count, const A& a, const B& b) {
    if (count >= spawnFrom) return oneapi::tbb::parallel_invoke(a, b);
    a();
    b();
  }

  /// From here on only halves fit above the depth limit: a split of 1 against the rest would need one level more.
  static bool mustHalve(std::uint32_t count, int depth) {
    return depth + 1 + int(std::bit_width(count - 2)) > bvhDepthLimit;
  }

  /// Where no split is any better than none, halves keep the tree shallow.
  std::uint32_t divide(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth, bool& sorted,
                       Box halves[2]) {
    std::uint32_t const count = end - begin;
    float const none = tree_[node].box.area() * float(count) * (1 - 1e-6f);
    if (!sorted) {
      std::span<std::uint32_t> const list(lists_.list(0).data() + begin, count);
      Split const split = divideByBins(primitives_, list, config_.bins, none, halves);
      if (split.axis >= 0) return begin + split.at;
      lists_.sort(begin, end);
      sorted = true;
    }
    Split split;
    split.axis = -1;
    if (!mustHalve(count, depth)) split = lists_.best(begin, end, none);
    if (split.axis < 0) split = lists_.median(begin, end);
    lists_.partition(begin, end, split, halves);
    return split.at;
  }

  const Primitives& primitives_;
  const BvhConfig& config_;
  SortedLists lists_;
  Tree tree_;
};

}  // namespace

Tree split(const Primitives& primitives, const BvhConfig& config) { return Splitter(primitives, config).run(); }

}  // namespace ropelight::bvh
