#include "render/scene/transform.h"

#include <algorithm>
#include <limits>

namespace ropelight {
namespace {

double frobenius(const Mat3d& m) {
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

double largestEntry(const Mat3d& m) {
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
  return largest;
}

/// Unit length without overflow or underflow on the way.
Vec3d normalized(Vec3d v) {
  double const largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : Vec3d(0);
}

}  // namespace

Mat4d translation(Vec3d offset) {
  Mat4d m(1.0);
  m[3] = glm::dvec4(offset, 1);
  return m;
}

Mat4d scaling(Vec3d factors) {
  Mat4d m(1.0);
  for (int i = 0; i < 3; ++i) m[i][i] = factors[i];
  return m;
}

Mat4d rotation(Vec3d axis, double degrees) {
  Vec3d const k = normalized(axis);
  double const angle = std::fmod(degrees, 360.0) * 3.14159265358979323846 / 180;
  double const c = std::cos(angle), s = std::sin(angle);
  Mat4d m(1.0);
  for (int i = 0; i < 3; ++i) {
    Vec3d e(0);
    e[i] = 1;
    m[i] = glm::dvec4(e * c + glm::cross(k, e) * s + k * (k[i] * (1 - c)), 0);
  }
  return m;
}

Mat4d quadToWorld(Vec3d corner, Vec3d edge1, Vec3d edge2) {
  Vec3d const normal = normalized(glm::cross(normalized(edge1), normalized(edge2)));
  double const length = std::sqrt(glm::length(edge1)) * std::sqrt(glm::length(edge2));
  return Mat4d(glm::dvec4(edge1, 0), glm::dvec4(edge2, 0), glm::dvec4(normal * length, 0), glm::dvec4(corner, 1));
}

double conditionNumber(const Mat3d& m) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double const largest = largestEntry(m);
  if (!(largest > 0) || !std::isfinite(largest)) return infinite;
  Mat3d const scaled = m * (1 / largest);
  Mat3d const cofactors(glm::cross(scaled[1], scaled[2]), glm::cross(scaled[2], scaled[0]),
                        glm::cross(scaled[0], scaled[1]));
  double const determinant = glm::dot(scaled[0], cofactors[0]);
  double const condition = frobenius(scaled) * (frobenius(cofactors) / std::abs(determinant)) / 3;
  return std::isfinite(condition) ? condition : infinite;
}

Vec3d transformPoint(const Mat4d& m, Vec3d p) { return Vec3d(m * glm::dvec4(p, 1)); }
Vec3d transformVector(const Mat4d& m, Vec3d v) { return Vec3d(m * glm::dvec4(v, 0)); }

}  // namespace ropelight
