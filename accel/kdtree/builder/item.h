#pragma once
// What the kd-tree's builders divide: cells, and the bounds of the primitives in them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ropelight {

struct KdBox {
  float min[3];
  float max[3];

  double extent(int axis) const { return double(max[axis]) - double(min[axis]); }
  /// Surface area.
  double area() const {
    double const x = extent(0), y = extent(1), z = extent(2);
    return 2 * (x * y + y * z + z * x);
  }
};

/// A primitive in a cell. A plane at s leaves it in the low child where min < s and in the high child where max > s:
/// the bounds reach past every float at which its padded surface begins or ends, so that none of them is planar.
struct KdItem {
  KdBox bounds;
  std::uint32_t primitive;
};

/// The largest float below x; −0 never comes out.
inline float floatBelow(double x) {
  float const f = float(x);
  return (double(f) < x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity())) + 0.0f;
}

/// The smallest float above x; −0 never comes out.
inline float floatAbove(double x) {
  float const f = float(x);
  return (double(f) > x ? f : std::nextafter(f, std::numeric_limits<float>::infinity())) + 0.0f;
}

inline void clamp(KdBox& bounds, const KdBox& cell) {
  for (int a = 0; a < 3; ++a) {
    bounds.min[a] = std::clamp(bounds.min[a], cell.min[a], cell.max[a]);
    bounds.max[a] = std::clamp(bounds.max[a], cell.min[a], cell.max[a]);
  }
}

inline void grow(KdBox& bounds, const KdBox& other) {
  for (int a = 0; a < 3; ++a) {
    bounds.min[a] = std::min(bounds.min[a], other.min[a]);
    bounds.max[a] = std::max(bounds.max[a], other.max[a]);
  }
}

}  // namespace ropelight
