#pragma once
// The oracle's own vectors and its brute-force ray queries.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/oracle/oracle.h"

namespace oracle {

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec normalize(Vec a) { return (1 / length(a)) * a; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// The direction is of unit length.
struct Ray {
  Vec origin, direction;
};

/// A parallelogram or triangle: the points p of a plane with u = gradU·p − offsetU and v likewise in [0, 1].
struct Flat {
  Vec normal;  ///< unit, towards the front
  Vec gradU, gradV;
  double distance, offsetU, offsetV;
  double maxSum;  ///< bound on u + v: 1 for triangles, 2 otherwise
  int shape;

  Flat(Vec corner, Vec edge1, Vec edge2, bool triangle, int id) : maxSum(triangle ? 1 : 2), shape(id) {
    Vec const n = cross(edge1, edge2);
    normal = normalize(n);
    gradU = (1 / dot(n, n)) * cross(edge2, n);
    gradV = (1 / dot(n, n)) * cross(n, edge1);
    distance = dot(normal, corner);
    offsetU = dot(gradU, corner);
    offsetV = dot(gradV, corner);
  }

  /// Distance along the ray within (near, far), else infinity.
  double intersect(Ray const& ray, double near, double far) const {
    constexpr double miss = std::numeric_limits<double>::infinity();
    double const t = (distance - dot(normal, ray.origin)) / dot(normal, ray.direction);
    if (!(t > near && t < far)) return miss;
    Vec const p = ray.origin + t * ray.direction;
    double const u = dot(gradU, p) - offsetU;
    double const v = dot(gradV, p) - offsetV;
    return u >= 0 && u <= 1 && v >= 0 && v <= 1 && u + v <= maxSum ? t : miss;
  }
};

struct Ball {
  Vec center;
  double radius;
  int shape;

  /// Distance along the ray within (near, far), else infinity.
  double intersect(Ray const& ray, double near, double far) const {
    constexpr double miss = std::numeric_limits<double>::infinity();
    Vec const toCenter = center - ray.origin;
    double const middle = dot(toCenter, ray.direction);
    Vec const off = toCenter - middle * ray.direction;
    double const square = radius * radius - dot(off, off);
    if (square < 0) return miss;
    double const half = std::sqrt(square);
    if (middle - half > near) return middle - half < far ? middle - half : miss;
    return middle + half > near && middle + half < far ? middle + half : miss;
  }
};

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  int shape = -1;
  Vec point;
  Vec normal;  ///< unit, towards the shape's front
};

/// All shapes, to be searched one by one.
struct Shapes {
  std::vector<Flat> flats;
  std::vector<Ball> balls;
  double epsilon = 0;  ///< hits nearer than this are the surface that the ray starts from

  Hit nearest(Ray const& ray) const {
    Hit hit;
    for (Flat const& flat : flats) {
      double const t = flat.intersect(ray, epsilon, hit.t);
      if (t < hit.t) hit = {t, flat.shape, {}, flat.normal};
    }
    Ball const* nearestBall = nullptr;
    for (Ball const& ball : balls) {
      double const t = ball.intersect(ray, epsilon, hit.t);
      if (t < hit.t) hit = {t, ball.shape, {}, {}}, nearestBall = &ball;
    }
    if (hit.shape < 0) return hit;
    hit.point = ray.origin + hit.t * ray.direction;
    if (nearestBall) hit.normal = normalize(hit.point - nearestBall->center);
    return hit;
  }

  bool blocked(Ray const& ray, double far) const {
    auto const hits = [&](auto const& shape) { return shape.intersect(ray, epsilon, far - epsilon) < far; };
    return std::any_of(flats.begin(), flats.end(), hits) || std::any_of(balls.begin(), balls.end(), hits);
  }
};

}  // namespace oracle
