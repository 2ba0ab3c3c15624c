#pragma once
// Builds bounding-volume hierarchies on the CPU by the surface-area heuristic (Goldsmith & Salmon 1987; Wald 2007).

#include <tuple>

#include "accel/bvh/bvh.h"
#include "render/flat/flat_scene.h"

namespace ropelight {

struct BvhConfig {
  bool sweep = true;         ///< every split between sorted centroids; else bins
  int bins = 32;             ///< per axis, at most 64; nodes of 32 or fewer primitives are swept all the same
  int leafSize = 4;          ///< most items of a leaf, at most BvhChild::maxItems
  double traversalCost = 1;  ///< of one inner node, in units of one primitive test
  int reinsertion = 2;       ///< passes that move subtrees to where they cost less (Meister & Bittner 2018)
  int threads = 0;           ///< 0: all cores; the result is the same for any number

  /// Everything that the BVH depends on.
  auto shape() const { return std::tuple(sweep, bins, leafSize, traversalCost, reinsertion); }
  bool operator==(const BvhConfig& other) const { return shape() == other.shape(); }
};

/// A binary BVH over all primitives of a scene that has at least one. Bounds are padded by what rounding can move a
/// traversal (2⁻²⁰ of the scene's reach). A single primitive makes a root whose two children both hold it. Never deeper
/// than bvhDepthLimit; fewer nodes than primitives (unless there is only one), one item per primitive. Throws Error
/// above 2²⁷ primitives, for which the node has no bits.
Bvh<2> buildBvh(const FlatScene& scene, const BvhConfig& config);

/// The same BVH with up to four children per node: the child of largest area is opened first.
Bvh<4> widen(const Bvh<2>& binary);

}  // namespace ropelight
