#include "render/scene/ellipsoid.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ropelight {

Vec3d singularValues(const Mat3d& m) {
  Mat3d a = m;  // pairs of columns are turned until all are orthogonal (one-sided Jacobi, Hestenes 1958)
  for (int sweep = 0; sweep < 32; ++sweep) {
    for (auto [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      double const product = glm::dot(a[p], a[q]);
      if (product == 0) continue;
      double const zeta = (glm::dot(a[q], a[q]) - glm::dot(a[p], a[p])) / (2 * product);
      double const t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(zeta, 1.0));
      double const c = 1 / std::hypot(t, 1.0), s = c * t;
      Vec3d const before = a[p];
      a[p] = c * before - s * a[q];
      a[q] = s * before + c * a[q];
    }
  }
  double v[3] = {glm::length(a[0]), glm::length(a[1]), glm::length(a[2])};
  std::sort(v, v + 3, std::greater<>());
  return Vec3d(v[0], v[1], v[2]);
}

double ellipsoidArea(const Mat3d& toWorld) {
  Vec3d const s = singularValues(toWorld);
  double const scale = s.x * s.x;  // R_G is homogeneous: work with ratios so that nothing overflows
  double const b = s.y / s.x, c = s.z / s.x;
  double x = b * b * c * c, y = c * c, z = b * b;
  // R_G from R_F and R_D: 2R_G = z R_F − (x−z)(y−z) R_D/3 + sqrt(xy/z), z the largest argument here.
  double const x0 = x, y0 = y, z0 = z;
  double sum = 0, power = 1;
  for (int i = 0; i < 60; ++i) {
    double const rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    double const lambda = rx * ry + ry * rz + rz * rx;
    sum += power / (rz * (z + lambda));
    power /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
  }
  double const rf = 1 / std::sqrt((x + y + z) / 3);
  double const rd = 3 * sum + power / std::pow((x + y + z) / 3, 1.5);
  double const rg = 0.5 * (z0 * rf - (x0 - z0) * (y0 - z0) * rd / 3 + std::sqrt(x0 * y0 / z0));
  return 4 * M_PI * scale * rg;
}

}  // namespace ropelight
