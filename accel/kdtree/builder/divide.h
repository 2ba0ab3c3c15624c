#pragma once
// The two children of a cell: which primitives each holds, and where.

#include <vector>

#include "accel/kdtree/builder/clip.h"
#include "accel/kdtree/builder/split.h"

namespace ropelight {

struct KdHalf {
  KdBox cell;
  std::vector<KdItem> items;            ///< in the order of the parent's
  std::vector<std::uint32_t> cutItems;  ///< those that the plane cut, ascending
};

struct KdDivision {
  static constexpr std::uint32_t wasCut = 0xFFFFFFFFu;

  KdHalf half[2];                          ///< low, high
  std::vector<std::uint32_t> destination;  ///< by item of the parent: wasCut, or its index in a half << 1 | half
};

/// Divides the items; the plane must split the cell. Without `follow`, cutItems and destination stay empty.
KdDivision divide(const std::vector<KdItem>& items, const KdBox& cell, const KdPlane& plane, const KdClipper& clipper,
                  bool follow);

}  // namespace ropelight
