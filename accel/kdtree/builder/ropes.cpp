#include <oneapi/tbb/parallel_invoke.h>

#include "accel/kdtree/builder/build.h"

namespace ropelight {
namespace {

class RopeConnector {
 public:
  explicit RopeConnector(KdTree& tree) : tree_(tree) {}

  void run() {
    Cell root{0, {}, {}};
    for (int f = 0; f < 6; ++f) {
      root.bounds[f] = tree_.bounds[f];
      root.ropes[f] = noRope;
    }
    connect(root, 0);
  }

 private:
  static constexpr int sharedDepth = 9;  ///< cells above it have their children done by several threads

  struct Cell {
    std::uint32_t node;
    float bounds[6];
    std::uint32_t ropes[6];
  };

  /// Reads nodes and writes leaves only, so that no order matters.
  void connect(Cell cell, int depth) {
    for (int f = 0; f < 6; ++f) cell.ropes[f] = tighten(cell, f);
    KdNode const n = tree_.nodes[cell.node];
    if (n.isLeaf()) return finish(cell, tree_.leaves[n.target()]);
    std::uint32_t const axis = n.axis();
    Cell low = cell, high = cell;
    low.node = cell.node + 1;
    high.node = n.target();
    low.bounds[axis + 3] = high.bounds[axis] = n.split;
    low.ropes[axis + 3] = high.node;
    high.ropes[axis] = low.node;
    auto const connectLow = [&] { connect(low, depth + 1); };
    auto const connectHigh = [&] { connect(high, depth + 1); };
    if (depth < sharedDepth) return oneapi::tbb::parallel_invoke(connectLow, connectHigh);
    connectLow();
    connectHigh();
  }

  /// Descends from a rope as long as one child covers the whole face.
  std::uint32_t tighten(const Cell& cell, int face) const {
    std::uint32_t rope = cell.ropes[face];
    if (rope == noRope) return rope;
    std::uint32_t const axis = std::uint32_t(face % 3);
    for (;;) {
      KdNode const n = tree_.nodes[rope];
      if (n.isLeaf()) return rope;
      if (n.axis() == axis) {
        rope = face < 3 ? n.target() : rope + 1;  // the child that touches the shared face
      } else if (n.split >= cell.bounds[n.axis() + 3]) {
        rope = rope + 1;
      } else if (n.split <= cell.bounds[n.axis()]) {
        rope = n.target();
      } else {
        return rope;
      }
    }
  }

  static void finish(const Cell& cell, KdLeaf& leaf) {
    for (int f = 0; f < 6; ++f) {
      leaf.bounds[f] = cell.bounds[f];
      leaf.ropes[f] = cell.ropes[f];
    }
  }

  KdTree& tree_;
};

}  // namespace

void connectRopes(KdTree& tree) { RopeConnector(tree).run(); }

}  // namespace ropelight
