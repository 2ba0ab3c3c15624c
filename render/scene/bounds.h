#pragma once
// Boxes along the axes, in double.

#include "render/core/vec.h"

namespace ropelight {

/// Axis-aligned bounds; empty where min > max.
struct Bounds {
  Vec3d min{1e300};
  Vec3d max{-1e300};

  void grow(Vec3d p);
  void grow(const Bounds& b);
  void clip(const Bounds& b);
  bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
  Vec3d extent() const { return max - min; }
  double area() const;  ///< surface area; 0 where empty
  bool overlaps(const Bounds& b) const;
};

}  // namespace ropelight
