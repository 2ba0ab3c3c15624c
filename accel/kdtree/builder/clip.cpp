#include "accel/kdtree/builder/clip.h"

#include <algorithm>
#include <cmath>

namespace ropelight {
namespace {

/// A convex polygon. A cut adds at most one corner, and where rounding has dented it at most half as many again: six
/// cuts of a quad never make more than 42.
struct Polygon {
  Vec3d corner[42];
  int size = 0;

  void add(Vec3d p) { corner[size++] = p; }
};

/// Keeps the part where sign·x ≤ sign·plane (Sutherland & Hodgman 1974).
void cut(const Polygon& polygon, int axis, double plane, double sign, Polygon& kept) {
  kept.size = 0;
  const Vec3d* p = &polygon.corner[std::max(polygon.size - 1, 0)];
  double dp = sign * ((*p)[axis] - plane);
  for (int i = 0; i < polygon.size; ++i) {
    const Vec3d* const q = &polygon.corner[i];
    double const dq = sign * ((*q)[axis] - plane);
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
      Vec3d crossing = *p + dp / (dp - dq) * (*q - *p);
      crossing[axis] = plane;
      kept.add(crossing);
    }
    if (dq <= 0) kept.add(*q);
    p = q;
    dp = dq;
  }
}

void boundsAlong(const Polygon& polygon, int axis, Bounds& bounds) {
  double lo = 1e300, hi = -1e300;
  for (int i = 0; i < polygon.size; ++i) {
    lo = std::min(lo, polygon.corner[i][axis]);
    hi = std::max(hi, polygon.corner[i][axis]);
  }
  bounds.min[axis] = lo;
  bounds.max[axis] = hi;
}

Bounds boundsOf(const Polygon& polygon) {
  Bounds bounds;
  for (int a = 0; a < 3; ++a) boundsAlong(polygon, a, bounds);
  return bounds;
}

/// Keeps what lies in the box.
void cutToBox(Polygon& polygon, const Bounds& box) {
  Polygon other;
  Polygon *now = &polygon, *next = &other;
  for (int a = 0; a < 3; ++a) {
    Bounds bounds;
    boundsAlong(*now, a, bounds);
    for (double sign : {-1.0, 1.0}) {
      if (now->size == 0 || (sign < 0 ? bounds.min[a] >= box.min[a] : bounds.max[a] <= box.max[a])) continue;
      cut(*now, a, sign < 0 ? box.min[a] : box.max[a], sign, *next);
      std::swap(now, next);
    }
  }
  if (now == &other) {
    polygon.size = other.size;
    std::copy_n(other.corner, other.size, polygon.corner);
  }
}

Polygon polygonOf(const FlatScene& scene, std::uint32_t primitive) {
  Polygon polygon;
  if (primitive < scene.quads.size()) {
    for (Vec3d p : scene.quads[primitive].corner) polygon.add(p);
  } else {
    const FlatTriangle& t = scene.triangles[primitive - scene.quads.size() - scene.spheres.size()];
    for (Vec3d p : {t.a, t.b, t.c}) polygon.add(p);
  }
  return polygon;
}

}  // namespace

KdClipper::KdClipper(const FlatScene& scene, bool clip)
    : scene_(scene),
      clip_(clip),
      padding_(std::ldexp(scene.reach, -20)),
      margin_(padding_ + std::ldexp(scene.reach, -40)) {}

KdItem KdClipper::whole(std::uint32_t primitive) const {
  return {padded(scene_.primitiveBounds(primitive)), primitive};
}

KdParts KdClipper::divide(const KdItem& item, const KdBox& cell, int axis, float position) const {
  KdParts parts{{item, item}, {true, true}};
  KdBox half[2] = {cell, cell};
  half[0].max[axis] = half[1].min[axis] = position;
  if (!scene_.isPolygon(item.primitive))
    for (int h = 0; h < 2; ++h) parts.present[h] = scene_.overlapsSurface(item.primitive, padded(half[h]));
  else if (clip_)
    dividePolygon(cell, axis, position, parts);
  for (int h = 0; h < 2; ++h) clamp(parts.item[h].bounds, half[h]);
  return parts;
}

void KdClipper::dividePolygon(const KdBox& cell, int axis, float position, KdParts& parts) const {
  Polygon whole = polygonOf(scene_, parts.item[0].primitive), part;
  cutToBox(whole, padded(cell));
  for (int h = 0; h < 2; ++h) {
    double const sign = h == 0 ? 1 : -1;
    cut(whole, axis, double(position) + sign * margin_, sign, part);
    parts.present[h] = part.size > 0;
    if (parts.present[h]) parts.item[h].bounds = padded(boundsOf(part));
  }
}

KdBox KdClipper::padded(const Bounds& surface) const {
  KdBox box;
  for (int a = 0; a < 3; ++a) {
    box.min[a] = floatBelow(surface.min[a] - margin_);
    box.max[a] = floatAbove(surface.max[a] + margin_);
  }
  return box;
}

Bounds KdClipper::padded(const KdBox& cell) const {
  return {Vec3d(cell.min[0], cell.min[1], cell.min[2]) - margin_,
          Vec3d(cell.max[0], cell.max[1], cell.max[2]) + margin_};
}

}  // namespace ropelight
