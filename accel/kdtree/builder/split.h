#pragma once
// Where to split a cell: at the middle, or where the surface-area heuristic expects the least work (MacDonald & Booth
// 1990; Wald & Havran 2006).

#include <span>
#include <tuple>

#include "accel/kdtree/builder/item.h"

namespace ropelight {

struct KdPlane {
  int axis = -1;  ///< −1: there is none
  float position = 0;
  double cost = std::numeric_limits<double>::infinity();  ///< expected, in units of one primitive test

  bool splits(const KdBox& cell) const { return axis >= 0 && position > cell.min[axis] && position < cell.max[axis]; }
  /// Ties go to the lowest axis, then to the lowest position, so that the order in which planes are tried does not
  /// matter.
  bool betterThan(const KdPlane& other) const {
    return std::tie(cost, axis, position) < std::tie(other.cost, other.axis, other.position);
  }
};

/// The best plane of those considered.
class KdHeuristic {
 public:
  /// traversalCost: of one inner node, in primitive tests. emptyBonus: share taken off the cost of planes with an empty
  /// side.
  KdHeuristic(const KdBox& cell, double traversalCost, double emptyBonus)
      : cell_(cell), traversalCost_(traversalCost), emptyBonus_(emptyBonus) {
    double const share = 2 / cell.area();
    for (int axis = 0; axis < 3; ++axis) {
      double const u = cell.extent(axis == 0 ? 1 : 0), v = cell.extent(axis == 2 ? 1 : 2);
      faces_[axis] = u * v * share;
      sides_[axis] = (u + v) * share;
    }
  }

  /// low, high: primitives on either side; those on both count twice.
  void consider(int axis, float position, std::size_t low, std::size_t high) {
    if (splits(axis, position)) consider({axis, position, expected(axis, position, low, high)});
  }
  void consider(const KdPlane& plane) {
    if (plane.betterThan(best_)) best_ = plane;
  }
  bool splits(int axis, float position) const { return KdPlane{axis, position}.splits(cell_); }
  const KdPlane& best() const { return best_; }

 private:
  double expected(int axis, float position, std::size_t low, std::size_t high) const {
    double const below = double(position) - double(cell_.min[axis]), above = double(cell_.max[axis]) - double(position);
    double const f = faces_[axis], s = sides_[axis];
    double const tests = (f + s * below) * double(low) + (f + s * above) * double(high);
    return traversalCost_ + tests * (low == 0 || high == 0 ? 1 - emptyBonus_ : 1);
  }

  KdBox cell_;
  double traversalCost_, emptyBonus_;
  double faces_[3], sides_[3];  ///< share of the cell's area: faces across each axis; the other four, per unit length
  KdPlane best_;
};

/// The middle of the longest axis.
KdPlane middlePlane(const KdBox& cell);

/// Considers `bins` + 1 planes per axis, evenly spaced over the items' bounds: the outermost cut off empty space.
void considerBins(std::span<const KdItem> items, int bins, KdHeuristic& heuristic);

/// Considers every plane at which one of at most fewItems items begins or ends; for so few this is quicker than to sort
/// or to bin them.
inline constexpr std::size_t fewItems = 16;
void considerAll(std::span<const KdItem> items, KdHeuristic& heuristic);

}  // namespace ropelight
