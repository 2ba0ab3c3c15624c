#include "accel/kd_build.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace ropelight {
namespace {

struct Split {
  int axis = -1;
  float position = 0;
  double cost = 0;
};

class Builder {
 public:
  Builder(const FlatScene& scene, const KdConfig& config) : scene_(scene), config_(config) {
    std::uint32_t const n = scene.primitiveCount();
    // Plane parameters are rounded three times and coordinates once: primitives reach this far into their neighbours.
    pad_ = std::ldexp(scene.reach, -20);
    bounds_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      bounds_[i] = scene.primitiveBounds(i);
      bounds_[i].min -= pad_;
      bounds_[i].max += pad_;
    }
    maxDepth_ = config.maxDepth > 0 ? config.maxDepth : automaticTreeDepth(n);
    maxReferences_ = 64 + 16 * std::size_t(n);
  }

  KdTree run() {
    Bounds root;
    for (const Bounds& b : bounds_) root.grow(b);
    if (root.empty()) root = Bounds{Vec3d(0.0), Vec3d(0.0)};
    for (int a = 0; a < 3; ++a) {
      tree_.bounds[a] = std::nextafter(float(root.min[a]), -INFINITY);
      tree_.bounds[a + 3] = std::nextafter(float(root.max[a]), INFINITY);
      root.min[a] = double(tree_.bounds[a]);
      root.max[a] = double(tree_.bounds[a + 3]);
    }
    rootArea_ = std::max(root.area(), 1e-300);
    std::vector<std::uint32_t> all(scene_.primitiveCount());
    std::iota(all.begin(), all.end(), 0u);
    pending_ = all.size();
    build(all, root, 0);
    connectRopes(tree_);
    return std::move(tree_);
  }

 private:
  void build(std::vector<std::uint32_t>& primitives, const Bounds& box, int depth) {
    tree_.stats.depth = std::max(tree_.stats.depth, depth);
    Split const split = choose(primitives, box, depth);
    std::size_t const node = tree_.nodes.size();
    tree_.nodes.emplace_back();
    if (split.axis < 0) return makeLeaf(node, primitives, box);

    Bounds low = box, high = box;
    low.max[split.axis] = high.min[split.axis] = double(split.position);
    std::vector<std::uint32_t> left, right;
    for (std::uint32_t p : primitives) {
      if (bounds_[p].min[split.axis] <= low.max[split.axis] && meets(p, low)) left.push_back(p);
      if (bounds_[p].max[split.axis] >= high.min[split.axis] && meets(p, high)) right.push_back(p);
    }
    pending_ += left.size() + right.size() - primitives.size();
    std::vector<std::uint32_t>().swap(primitives);
    tree_.stats.sahCost += config_.traversalCost * box.area() / rootArea_;
    build(left, low, depth + 1);
    tree_.nodes[node].split = split.position;
    tree_.nodes[node].link = std::uint32_t(tree_.nodes.size()) << 2 | std::uint32_t(split.axis);
    build(right, high, depth + 1);
  }

  bool meets(std::uint32_t p, Bounds box) const {
    box.min -= pad_;
    box.max += pad_;
    return scene_.overlapsSurface(p, box);
  }

  void makeLeaf(std::size_t node, const std::vector<std::uint32_t>& primitives, const Bounds& box) {
    tree_.nodes[node].link = std::uint32_t(tree_.leaves.size()) << 2 | 3u;
    KdLeaf leaf;
    leaf.first = std::uint32_t(tree_.references.size());
    leaf.count = std::uint32_t(primitives.size());
    tree_.leaves.push_back(leaf);
    tree_.references.insert(tree_.references.end(), primitives.begin(), primitives.end());
    tree_.stats.sahCost += double(primitives.size()) * box.area() / rootArea_;
  }

  Split choose(const std::vector<std::uint32_t>& primitives, const Bounds& box, int depth) const {
    if (depth >= maxDepth_ || int(primitives.size()) <= config_.leafSize) return {};
    if (pending_ > maxReferences_) return {};
    return config_.midpoint ? chooseMidpoint(box) : chooseSah(primitives, box);
  }

  static bool inside(float position, const Bounds& box, int axis) {
    return double(position) > box.min[axis] && double(position) < box.max[axis];
  }

  static Split chooseMidpoint(const Bounds& box) {
    Vec3d const e = box.extent();
    int const axis = e.x >= e.y ? (e.x >= e.z ? 0 : 2) : (e.y >= e.z ? 1 : 2);
    float const position = float(0.5 * (box.min[axis] + box.max[axis]));
    return inside(position, box, axis) ? Split{axis, position, 0} : Split{};
  }

  Split chooseSah(const std::vector<std::uint32_t>& primitives, const Bounds& box) const {
    Split best;
    best.cost = double(primitives.size());
    for (int axis = 0; axis < 3; ++axis) trySahAxis(primitives, box, axis, best);
    return best;
  }

  /// Counts how many primitives begin and end in each bin; the planes between bins are the candidates.
  void trySahAxis(const std::vector<std::uint32_t>& primitives, const Bounds& box, int axis, Split& best) const {
    double const lo = box.min[axis], width = box.max[axis] - lo;
    int const bins = config_.bins;
    if (!(width > 0)) return;
    std::vector<std::uint32_t> begins(std::size_t(bins), 0), ends(std::size_t(bins), 0);
    auto bin = [&](double x) { return std::size_t(std::clamp(int((x - lo) / width * bins), 0, bins - 1)); };
    for (std::uint32_t p : primitives) {
      ++begins[bin(std::max(bounds_[p].min[axis], lo))];
      ++ends[bin(std::min(bounds_[p].max[axis], box.max[axis]))];
    }
    std::size_t left = 0, right = primitives.size();
    for (int k = 1; k < bins; ++k) {
      left += begins[std::size_t(k - 1)];
      right -= ends[std::size_t(k - 1)];
      float const position = float(lo + width * k / bins);
      if (inside(position, box, axis)) consider(box, axis, position, left, right, best);
    }
  }

  void consider(const Bounds& box, int axis, float position, std::size_t left, std::size_t right, Split& best) const {
    Bounds low = box, high = box;
    low.max[axis] = high.min[axis] = double(position);
    double const area = box.area();
    double cost = (low.area() * double(left) + high.area() * double(right)) / area;
    if (left == 0 || right == 0) cost *= 1 - config_.emptyBonus;
    cost += config_.traversalCost;
    if (cost < best.cost) best = Split{axis, position, cost};
  }

  const FlatScene& scene_;
  KdConfig config_;
  KdTree tree_;
  std::vector<Bounds> bounds_;
  double pad_ = 0, rootArea_ = 1;
  int maxDepth_ = 0;
  std::size_t pending_ = 0, maxReferences_ = 0;
};

}  // namespace

int automaticTreeDepth(std::uint32_t primitives) { return int(8 + 1.3 * std::log2(std::max(1.0, double(primitives)))); }

KdTree buildKdTree(const FlatScene& scene, const KdConfig& config) {
  auto const start = std::chrono::steady_clock::now();
  KdTree tree = Builder(scene, config).run();
  tree.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return tree;
}

}  // namespace ropelight
