#include "render/polygon/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/polygon/ear_clipping.h"

namespace ropelight {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double largest(Vec3d v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Whether a triangle is higher than the rounding of its corners.
bool hasArea(Vec3d a, Vec3d b, Vec3d c) {
  Vec3d const u = b - a, v = c - a;
  double const rounding = 2 * epsilon * std::max({largest(a), largest(b), largest(c)});
  return largest(glm::cross(u, v)) > rounding * std::max(largest(u), largest(v));
}

/// Perpendicular to a unit vector and to each other; x × y is along the normal. Along the axes where it is.
struct PlaneAxes {
  explicit PlaneAxes(Vec3d normal) {
    Vec3d const size = glm::abs(normal);
    int const least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    Vec3d axis(0.0);
    axis[least] = 1;
    x = glm::normalize(glm::cross(axis, normal));
    y = glm::cross(normal, x);
  }
  Vec3d x, y;
};

}  // namespace

void PolygonCutter::scale(const std::vector<std::uint32_t>& corners, const std::vector<Vec3d>& positions) {
  points_.clear();
  Vec3d low = positions[corners[0]], high = low;
  for (std::uint32_t const corner : corners) {
    points_.push_back(positions[corner]);
    low = glm::min(low, points_.back());
    high = glm::max(high, points_.back());
  }
  Vec3d const center = low + (high - low) / 2.0;
  double const size = largest(high - low) / 2;
  if (size > 0)
    for (Vec3d& p : points_) p = (p - center) / size;
  rounding_ = 4 * epsilon * (1 + std::max(largest(low), largest(high)) / std::max(size, 1e-300));
}

double PolygonCutter::departure() const {
  Vec3d low = points_[0], high = low, mean(0.0);
  for (const Vec3d& p : points_) {
    low = glm::min(low, p);
    high = glm::max(high, p);
    mean += p / double(points_.size());
  }
  double most = 0;
  for (const Vec3d& p : points_) most = std::max(most, std::abs(glm::dot(p - mean, normal_)));
  return most / glm::length(high - low);
}

/// Whether the corners, seen from the first, go round it one way, less than once, and never straight towards it.
bool PolygonCutter::fanFits() const {
  Vec3d const first = points_[1] - points_[0];
  bool beyondHalf = false;
  for (std::size_t i = 2; i < points_.size(); ++i) {
    Vec3d const u = points_[i - 1] - points_[0], v = points_[i] - points_[0];
    double const area = glm::dot(glm::cross(u, v), normal_);
    if (!(area > 4 * rounding_ * std::max(largest(u), largest(v)))) return false;
    double const side = glm::dot(glm::cross(first, v), normal_);
    if (beyondHalf && side >= 0) return false;
    beyondHalf = side < 0;
  }
  return true;
}

/// Makes the pieces of the corners on a grid in the plane; whether the outline crosses itself.
bool PolygonCutter::clip() {
  PlaneAxes const axes(normal_);
  double const scale = double(gridReach) / 2;  // the corners are within √3 of the centre
  std::vector<GridPoint> outline;
  for (const Vec3d& p : points_)
    outline.push_back({std::llround(scale * glm::dot(p, axes.x)), std::llround(scale * glm::dot(p, axes.y))});
  double const tolerance = 4 + 4 * rounding_ * scale;
  bool const crossing = crossesItself(outline, tolerance);
  return !clipEars(outline, tolerance, pieces_) || crossing;
}

void PolygonCutter::fan() {
  for (std::uint32_t i = 2; i < points_.size(); ++i) pieces_.emplace_back(0, i - 1, i);
}

/// Cuts the points into pieces, and says what the polygon turned out to be.
PolygonFacts PolygonCutter::divide() {
  PolygonFacts facts;
  double all = 0;
  Vec3d newell(0.0);
  for (std::size_t i = 2; i < points_.size(); ++i) {
    Vec3d const twice = glm::cross(points_[i - 1] - points_[0], points_[i] - points_[0]);
    newell += twice;
    all += glm::length(twice);
  }
  if (!(all > rounding_ * double(points_.size()))) return facts;
  constexpr double cancelled = 1e-9;  // parts that turn either way, such as the halves of an 8
  if (glm::length(newell) <= cancelled * all) {
    facts.crossing = true;
    fan();
    return facts;
  }
  normal_ = glm::normalize(newell);
  facts.departure = departure();
  if (fanFits())
    fan();
  else
    facts.crossing = clip();
  return facts;
}

PolygonFacts PolygonCutter::cut(const std::vector<std::uint32_t>& corners, const std::vector<Vec3d>& positions,
                                std::vector<glm::uvec3>& triangles) {
  PolygonFacts facts;
  pieces_.assign(1, glm::uvec3(0, 1, 2));
  if (corners.size() > 3) {
    pieces_.clear();
    scale(corners, positions);
    facts = divide();
  }
  for (const glm::uvec3& piece : pieces_) {
    glm::uvec3 const t(corners[piece.x], corners[piece.y], corners[piece.z]);
    if (hasArea(positions[t.x], positions[t.y], positions[t.z])) triangles.push_back(t);
  }
  return facts;
}

}  // namespace ropelight
