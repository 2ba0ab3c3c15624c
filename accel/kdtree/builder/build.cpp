#include "accel/kdtree/builder/build.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "accel/kdtree/builder/subtree.h"
#include "accel/kdtree/builder/sweep.h"

namespace ropelight {
namespace {

constexpr std::size_t serialSize = 4096;  ///< primitives below which one thread makes the subtree

struct Work {
  KdBox cell;
  std::vector<KdItem> items;
  KdEvents events;  ///< of sweep, and not of few items
  std::uint64_t budget = 0;
  int depth = 0;
  int badSplits = 0;  ///< in a row, above this node
};

struct Children {
  KdPlane plane;
  Work low, high;
};

class Builder {
 public:
  Builder(const FlatScene& scene, const KdConfig& config)
      : config_(config),
        clipper_(scene, config.clip),
        primitives_(scene.primitiveCount()),
        maxDepth_(config.maxDepth > 0 ? config.maxDepth : automaticTreeDepth(primitives_)) {}

  KdTree run() const {
    Work root = wholeScene();
    KdTree tree;
    std::copy_n(root.cell.min, 3, tree.bounds);
    std::copy_n(root.cell.max, 3, tree.bounds + 3);
    double const area = root.cell.area();
    auto subtree = build(std::move(root));
    tree.stats.sahCost = subtree->measure.cost / area;
    tree.stats.depth = subtree->measure.height;
    tree.stats.budgetHits = subtree->measure.budgetHits;
    assemble(std::move(subtree), tree);
    return tree;
  }

 private:
  Work wholeScene() const {
    Work root;
    root.budget = kdTreeBudget(primitives_);
    root.items.resize(primitives_);
    oneapi::tbb::parallel_for(0u, primitives_, [&](std::uint32_t i) { root.items[i] = clipper_.whole(i); });
    for (int a = 0; a < 3; ++a) {
      root.cell.min[a] = floatBelow(0);
      root.cell.max[a] = floatAbove(0);
    }
    if (!root.items.empty()) root.cell = root.items[0].bounds;
    for (const KdItem& item : root.items) grow(root.cell, item.bounds);
    if (config_.split == KdSplit::sweep && primitives_ > fewItems) root.events = KdEvents(root.items);
    return root;
  }

  /// Above serialSize both halves at the same time.
  std::unique_ptr<KdSubtree> build(Work work) const {
    auto subtree = std::make_unique<KdSubtree>();
    std::size_t const primitives = work.items.size();
    if (primitives <= serialSize) {
      subtree->measure = add(std::move(work), subtree->part);
      subtree->size = subtree->part.end();
      return subtree;
    }
    double const area = work.cell.area();
    std::optional<Children> children = split(work, subtree->measure.budgetHits);
    if (!children) {
      subtree->part.addLeaf(work.items);
      subtree->measure.cost = area * double(primitives);
      subtree->size = subtree->part.end();
      return subtree;
    }
    subtree->plane = children->plane;
    oneapi::tbb::parallel_invoke([&] { subtree->half[0] = build(std::move(children->low)); },
                                 [&] { subtree->half[1] = build(std::move(children->high)); });
    subtree->measure = join(area, subtree->half[0]->measure, subtree->half[1]->measure);
    subtree->size = KdPart::Mark{1, 0, 0} + subtree->half[0]->size + subtree->half[1]->size;
    if (isWaste(subtree->measure, area, primitives))
      subtree->measure = leaf(area, subtree->collapse(), subtree->measure);
    return subtree;
  }

  KdMeasure add(Work work, KdPart& part) const {
    double const area = work.cell.area();
    std::size_t const primitives = work.items.size();
    KdMeasure none;
    std::optional<Children> children = split(work, none.budgetHits);
    if (!children) {
      part.addLeaf(work.items);
      return leaf(area, primitives, none);
    }
    KdPart::Mark const begin = part.end();
    std::size_t const node = part.addInner(children->plane);
    KdMeasure const low = add(std::move(children->low), part);
    part.beginHigh(node);
    KdMeasure const both = join(area, low, add(std::move(children->high), part));
    return isWaste(both, area, primitives) ? leaf(area, part.collapse(begin), both) : both;
  }

  static KdMeasure leaf(double area, std::size_t primitives, const KdMeasure& tried) {
    return {area * double(primitives), 0, tried.budgetHits};
  }

  KdMeasure join(double area, const KdMeasure& low, const KdMeasure& high) const {
    return {config_.traversalCost * area + low.cost + high.cost, 1 + std::max(low.height, high.height),
            low.budgetHits + high.budgetHits};
  }

  bool isWaste(const KdMeasure& subtree, double area, std::size_t primitives) const {
    return config_.split != KdSplit::midpoint && subtree.cost > area * double(primitives);
  }

  /// Takes the work's items where it splits; else leaves them.
  std::optional<Children> split(Work& work, std::uint64_t& budgetHits) const {
    if (work.depth >= maxDepth_ || work.items.size() <= std::size_t(std::max(config_.leafSize, 0))) return {};
    KdPlane const plane = choose(work);
    bool const hope = work.badSplits < config_.badSplits;
    if (!plane.splits(work.cell) || (isDear(plane, work.items.size()) && !hope)) return {};
    KdDivision division = divide(work.items, work.cell, plane, clipper_, !work.events.empty());
    bool const bad = isDear(plane, work.items.size()) || partsNothing(division, work.items.size());
    if (bad && !hope) return {};
    std::uint64_t const low = weight(division.half[0]), high = weight(division.half[1]);
    if (low + high > work.budget) {
      ++budgetHits;
      return {};
    }
    std::uint64_t const spare = work.budget - low - high, toLow = spare * low / (low + high);
    int const badSplits = bad ? work.badSplits + 1 : 0;
    Children children{plane, child(work, division, 0, low + toLow, badSplits),
                      child(work, division, 1, high + spare - toLow, badSplits)};
    work = Work{};
    return children;
  }

  KdPlane choose(const Work& work) const {
    if (config_.split == KdSplit::midpoint) return middlePlane(work.cell);
    KdHeuristic heuristic(work.cell, config_.traversalCost, config_.emptyBonus);
    bool const few = work.items.size() <= fewItems;
    if (!work.events.empty())
      work.events.considerAll(heuristic);
    else if (few && (config_.split == KdSplit::sweep || 2 * work.items.size() <= std::size_t(config_.bins)))
      considerAll(work.items, heuristic);
    else
      considerBins(work.items, config_.bins, heuristic);
    return heuristic.best();
  }

  /// Whether the heuristic expects the split to cost no less than a leaf.
  bool isDear(const KdPlane& plane, std::size_t primitives) const {
    return config_.split != KdSplit::midpoint && plane.cost >= double(primitives);
  }

  static bool partsNothing(const KdDivision& division, std::size_t primitives) {
    return division.half[0].items.size() == primitives && division.half[1].items.size() == primitives;
  }

  static std::uint64_t weight(const KdHalf& half) { return std::max<std::uint64_t>(1, half.items.size()); }

  static Work child(const Work& parent, KdDivision& division, int h, std::uint64_t budget, int badSplits) {
    Work work;
    KdHalf& half = division.half[h];
    if (!parent.events.empty() && half.items.size() > fewItems) work.events = parent.events.ofHalf(division, h);
    work.cell = half.cell;
    work.items = std::move(half.items);
    work.budget = budget;
    work.depth = parent.depth + 1;
    work.badSplits = badSplits;
    return work;
  }

  KdConfig config_;
  KdClipper clipper_;
  std::uint32_t primitives_;
  int maxDepth_;
};

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void measureSizes(std::uint32_t primitives, KdTree& tree) {
  KdTreeStats& s = tree.stats;
  s.duplicates = primitives > 0 ? double(tree.references.size()) / double(primitives) : 1;
  for (const KdLeaf& leaf : tree.leaves) s.largestLeaf = std::max(s.largestLeaf, leaf.count);
}

}  // namespace

int automaticTreeDepth(std::uint32_t primitives) { return int(8 + 1.3 * std::log2(std::max(1.0, double(primitives)))); }

std::uint64_t kdTreeBudget(std::uint32_t primitives) {
  return std::min<std::uint64_t>(64 + 16 * std::uint64_t(primitives), std::uint64_t(1) << 29);
}

KdTree buildKdTree(const FlatScene& scene, const KdConfig& config) {
  namespace tbb = oneapi::tbb;
  auto const start = std::chrono::steady_clock::now();
  tbb::global_control const limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(std::max(config.threads, tbb::info::default_concurrency())));
  tbb::task_arena arena(config.threads > 0 ? config.threads : tbb::task_arena::automatic);
  KdTree tree;
  arena.execute([&] {
    tree = Builder(scene, config).run();
    auto const built = std::chrono::steady_clock::now();
    connectRopes(tree);
    tree.stats.ropeSeconds = since(built);
  });
  measureSizes(scene.primitiveCount(), tree);
  tree.stats.seconds = since(start);
  return tree;
}

}  // namespace ropelight
