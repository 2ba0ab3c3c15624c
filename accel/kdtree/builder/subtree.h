#pragma once
// Parts of a kd-tree while it is built: each thread makes its own, and the parts are joined once at the end.

#include <memory>
#include <vector>

#include "accel/kdtree/builder/item.h"
#include "accel/kdtree/builder/split.h"
#include "accel/kdtree/kd_tree.h"

namespace ropelight {

/// Nodes in depth-first order whose links count from the part's own first node and leaf.
class KdPart {
 public:
  /// A place in the part's arrays.
  struct Mark {
    std::size_t nodes = 0, leaves = 0, references = 0;

    Mark operator+(const Mark& m) const { return {nodes + m.nodes, leaves + m.leaves, references + m.references}; }
  };

  Mark end() const { return {nodes_.size(), leafSizes_.size(), references_.size()}; }
  void addLeaf(const std::vector<KdItem>& items);
  /// Its low child comes next.
  std::size_t addInner(const KdPlane& plane);
  /// The high child of the node comes next.
  void beginHigh(std::size_t node);
  /// Replaces all that follows by one leaf with the same references, ascending and each once; returns their number.
  std::size_t collapse(const Mark& from);
  /// Takes the references out of another part, to the end of its own.
  void addReferences(const KdPart& other);
  void copyTo(KdTree& tree, const Mark& at) const;

 private:
  std::vector<KdNode> nodes_;
  std::vector<std::uint32_t> leafSizes_;
  std::vector<std::uint32_t> references_;
};

/// What a finished subtree costs. Sums of the same numbers in the same order, whatever the threads.
struct KdMeasure {
  double cost = 0;  ///< Σ area · (traversal cost, or primitives of a leaf)
  int height = 0;
  std::uint64_t budgetHits = 0;
};

/// A subtree made by one thread, or a plane over two others.
struct KdSubtree {
  KdPart part;
  KdPlane plane;
  std::unique_ptr<KdSubtree> half[2];
  KdMeasure measure;
  KdPart::Mark size;

  /// Becomes one leaf; returns the number of its primitives.
  std::size_t collapse();
};

/// Puts the subtree's nodes, leaves and references in their places, in parallel, and frees it piece by piece.
void assemble(std::unique_ptr<KdSubtree> root, KdTree& tree);

}  // namespace ropelight
