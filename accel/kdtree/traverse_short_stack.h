#pragma once
// Traversal of the kd-tree with a stack of a few entries that forgets its oldest: when it is empty the walk restarts at
// the lowest node known to hold the rest of the ray (Horn et al. 2007, "Interactive k-D Tree GPU Raytracing").

#include "accel/kdtree/traverse_ropes.h"

namespace ropelight::RL_TARGET {

/// The last `capacity` entries pushed.
class ShortStack {
 public:
  static constexpr int capacity = 4;

  struct Entry {
    std::uint32_t node;
    Real exit;
  };

  RL_HD void push(Entry e) {
    for (int i = capacity - 1; i > 0; --i) entries_[i] = entries_[i - 1];  // no index: the entries stay in registers
    entries_[0] = e;
    size_ = size_ < capacity ? size_ + 1 : capacity;
  }
  RL_HD bool pop(Entry& e) {
    if (size_ == 0) return false;
    e = entries_[0];
    for (int i = 1; i < capacity; ++i) entries_[i - 1] = entries_[i];
    --size_;
    return true;
  }

 private:
  Entry entries_[capacity] = {};
  int size_ = 0;
};

/// As traverseRopes: test(primitive) for the primitives of every cell along the ray until done(t), t being where the
/// ray leaves the cell just tested. Planes are compared by the same monotone parameter, so that each step goes forward.
template <class Test, class Done>
RL_HD void traverseShortStack(const KdTreeView& tree, const Ray& ray, Test&& test, Done&& done) {
  RayPlanes const planes(ray);
  std::uint32_t face;
  Real const last = planes.exit(tree.bounds, face);
  Real enter = planes.enter(tree.bounds), exit = enter;
  if (!(enter <= last)) return;
  ShortStack stack;
  std::uint32_t restart = 0;
  for (;;) {
    ShortStack::Entry next{restart, last};
    bool pushDown = !stack.pop(next);
    std::uint32_t node = next.node;
    enter = exit;
    exit = next.exit;
    KdNode n = tree.nodes[node];
    while (!n.isLeaf()) {
      Real const plane = planes.at(n.axis(), n.split);
      bool const forward = planes.forward(n.axis());
      std::uint32_t const nearChild = forward ? node + 1 : n.target(), farChild = forward ? n.target() : node + 1;
      if (plane >= exit) {
        node = nearChild;
      } else if (!(plane > enter)) {  // NaN too: the ray runs in the plane
        node = farChild;
      } else {
        stack.push({farChild, exit});
        node = nearChild;
        exit = plane;
        pushDown = false;
      }
      if (pushDown) restart = node;
      n = tree.nodes[node];
    }
    const KdLeaf& leaf = tree.leaves[n.target()];
    for (std::uint32_t k = 0; k < leaf.count; ++k) test(tree.references[leaf.first + k]);
    if (done(exit) || exit >= last) return;
  }
}

}  // namespace ropelight::RL_TARGET
