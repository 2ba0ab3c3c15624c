#include "render/coincidence/facet.h"

#include <algorithm>
#include <cmath>

namespace ropelight {
namespace {

constexpr double rounding = 0x1p-24;     // of a float
constexpr double parallelCosine = 0.99;  // planes at a larger angle share no more than an edge

Facet makePolygon(const Vec3d* corners, int count, Vec3d e1, Vec3d e2) {
  Facet f;
  f.corners = count;
  for (int i = 0; i < count; ++i) f.box.grow(f.corner[i] = corners[i]);
  Vec3d const cross = glm::cross(e1, e2);
  double const length = glm::length(cross);
  f.normal = length > 0 ? cross / length : Vec3d(0.0);
  f.bound = 8 * rounding * glm::dot(glm::abs(f.normal), glm::abs(corners[0]) + glm::abs(e1) + glm::abs(e2));
  f.size = glm::length(f.box.extent());
  return f;
}

/// How far the polygons overlap along an axis; negative where they are apart.
double overlapAlong(const Facet& a, const Facet& b, Vec3d axis) {
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  const Facet* const both[2] = {&a, &b};
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < both[k]->corners; ++i) {
      double const x = glm::dot(axis, both[k]->corner[i] - a.corner[0]);
      low[k] = std::min(low[k], x);
      high[k] = std::max(high[k], x);
    }
  return std::min(high[0], high[1]) - std::max(low[0], low[1]);
}

/// Convex polygons of one plane are apart where an edge of one separates them.
bool overlap(const Facet& a, const Facet& b, Vec3d normal, double tolerance) {
  for (const Facet* f : {&a, &b})
    for (int i = 0; i < f->corners; ++i) {
      Vec3d const edge = f->corner[(i + 1) % f->corners] - f->corner[i], axis = glm::cross(normal, edge);
      double const length = glm::length(axis);
      if (length > 0 && overlapAlong(a, b, axis / length) <= tolerance) return false;
    }
  return true;
}

bool coplanar(const Facet& large, const Facet& small, double tolerance) {
  for (int i = 0; i < small.corners; ++i)
    if (!(std::abs(glm::dot(large.normal, small.corner[i] - large.corner[0])) <= tolerance)) return false;
  return true;
}

bool sameEllipsoid(const FlatSphere& a, const FlatSphere& b, double tolerance) {
  if (glm::length(a.center - b.center) > tolerance) return false;
  Mat3d const ga = a.toWorld * glm::transpose(a.toWorld), gb = b.toWorld * glm::transpose(b.toWorld);
  double largest = 0, difference = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      largest = std::max(largest, std::abs(ga[c][r]));
      difference = std::max(difference, std::abs(ga[c][r] - gb[c][r]));
    }
  return difference <= 2 * tolerance * std::sqrt(largest);
}

}  // namespace

Facet makeFacet(const FlatQuad& q) {
  return makePolygon(q.corner, 4, q.corner[1] - q.corner[0], q.corner[3] - q.corner[0]);
}

Facet makeFacet(const FlatTriangle& t) {
  Vec3d const corners[3] = {t.a, t.b, t.c};
  return makePolygon(corners, 3, t.b - t.a, t.c - t.a);
}

Facet makeFacet(const FlatSphere& s) {
  Facet f;
  f.sphere = s;
  Vec3d const reach = glm::abs(s.toWorld[0]) + glm::abs(s.toWorld[1]) + glm::abs(s.toWorld[2]);
  Vec3d const terms = glm::abs(s.center) + reach;
  f.bound = 10 * rounding * std::max({terms.x, terms.y, terms.z});
  f.box = {s.center - reach, s.center + reach};
  f.size = glm::length(f.box.extent());
  return f;
}

double placeTolerance(const Facet& a, const Facet& b) {
  return 2 * (a.bound + b.bound) + 4 * rounding * std::min(a.size, b.size);
}

bool covers(const Facet& large, const Facet& small) {
  if (large.curved() || small.curved()) return false;
  double const tolerance = placeTolerance(large, small);
  for (int i = 0; i < large.corners; ++i) {
    Vec3d const inward = glm::cross(large.normal, large.corner[(i + 1) % large.corners] - large.corner[i]);
    double const length = glm::length(inward);
    for (int k = 0; k < small.corners; ++k)
      if (glm::dot(inward, small.corner[k] - large.corner[i]) < -tolerance * length) return false;
  }
  return true;
}

bool coincide(const Facet& a, const Facet& b) {
  if (a.curved() != b.curved()) return false;
  double const tolerance = placeTolerance(a, b);
  if (a.curved()) return sameEllipsoid(a.sphere, b.sphere, tolerance);
  if (!(std::abs(glm::dot(a.normal, b.normal)) > parallelCosine)) return false;
  const Facet &large = a.size < b.size ? b : a, &small = a.size < b.size ? a : b;
  return coplanar(large, small, tolerance) && overlap(large, small, large.normal, 4 * tolerance);
}

}  // namespace ropelight
