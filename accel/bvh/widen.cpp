#include <algorithm>
#include <chrono>
#include <limits>

#include "accel/bvh/build.h"

namespace ropelight {
namespace {

/// One child of a binary node, as a value of its own.
struct Slot {
  float min[3], max[3];
  BvhChild child;

  Slot(const BvhNode<2>& node, int k) : child(node.child[k]) {
    for (int a = 0; a < 3; ++a) min[a] = node.min[a][k], max[a] = node.max[a][k];
  }
  double area() const {
    double const x = double(max[0]) - double(min[0]), y = double(max[1]) - double(min[1]);
    double const z = double(max[2]) - double(min[2]);
    return x * (y + z) + y * z;
  }
};

class Widener {
 public:
  explicit Widener(const Bvh<2>& binary) : binary_(binary) {}

  Bvh<4> run() {
    out_.items = binary_.items;
    double const rootArea = areaOf(binary_.nodes[0]);
    out_.stats.depth = add(0, rootArea);
    out_.stats.sahCost = rootArea > 0 ? cost_ / rootArea : double(out_.items.size());
    return std::move(out_);
  }

 private:
  static double areaOf(const BvhNode<2>& node) {
    Slot all(node, 0);
    for (int a = 0; a < 3; ++a) {
      all.min[a] = std::min(all.min[a], node.min[a][1]);
      all.max[a] = std::max(all.max[a], node.max[a][1]);
    }
    return all.area();
  }

  /// Opens the largest inner child until there are four or none is left to open.
  std::vector<Slot> childrenOf(std::uint32_t node) const {
    std::vector<Slot> slots = {Slot(binary_.nodes[node], 0), Slot(binary_.nodes[node], 1)};
    while (slots.size() < 4) {
      auto const largest = std::max_element(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
        return (a.child.isLeaf() ? -1 : a.area()) < (b.child.isLeaf() ? -1 : b.area());
      });
      if (largest->child.isLeaf()) break;
      const BvhNode<2>& opened = binary_.nodes[largest->child.index()];
      *largest = Slot(opened, 0);
      slots.emplace_back(opened, 1);
    }
    return slots;
  }

  /// Depth first; returns the depth.
  int add(std::uint32_t node, double area) {
    std::size_t const at = out_.nodes.size();
    out_.nodes.push_back(nothing());
    cost_ += area;
    std::vector<Slot> const slots = childrenOf(node);
    int depth = 0;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      BvhChild child = slots[k].child;
      if (child.isLeaf()) {
        cost_ += slots[k].area() * child.count();
        ++out_.stats.leaves;
      } else {
        child = BvhChild::inner(std::uint32_t(out_.nodes.size()));
        depth = std::max(depth, add(slots[k].child.index(), slots[k].area()));
      }
      for (int a = 0; a < 3; ++a) {
        out_.nodes[at].min[a][k] = slots[k].min[a];
        out_.nodes[at].max[a][k] = slots[k].max[a];
      }
      out_.nodes[at].child[k] = child;
    }
    return depth + 1;
  }

  static BvhNode<4> nothing() {
    BvhNode<4> node{};
    std::fill_n(&node.min[0][0], 12, std::numeric_limits<float>::infinity());
    std::fill_n(&node.max[0][0], 12, -std::numeric_limits<float>::infinity());
    return node;
  }

  const Bvh<2>& binary_;
  Bvh<4> out_;
  double cost_ = 0;
};

}  // namespace

Bvh<4> widen(const Bvh<2>& binary) {
  auto const start = std::chrono::steady_clock::now();
  Bvh<4> wide = Widener(binary).run();
  wide.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return wide;
}

}  // namespace ropelight
