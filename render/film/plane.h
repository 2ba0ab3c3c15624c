#pragma once
// One number per pixel, and separable filters over it.

#include <cstddef>
#include <vector>

namespace ropelight {

struct Plane {
  int width = 0;
  int height = 0;
  std::vector<double> values;  ///< width·height, row by row from the top

  Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}

  double* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
  const double* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
};

/// Weights at −radius … radius, an odd number of them.
using Kernel = std::vector<double>;

/// out(x, y) = Σᵢⱼ alongX[i]·alongY[j]·in(x + i, y + j), where the plane goes on beyond its edges with the edge's
/// values. In parallel over rows; every sum runs in the same order for any number of threads.
Plane filterPlane(const Plane& in, const Kernel& alongX, const Kernel& alongY);

}  // namespace ropelight
