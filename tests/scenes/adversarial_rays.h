#pragma once
// Rays on which tracers fail: along axes, in the planes of a structure, from and through vertices and edges, tangent,
// from inside, from afar, with components from the smallest to the largest.

#include <cmath>
#include <utility>

#include "render/intersection/intersect.h"
#include "tests/scenes/geometry_scenes.h"

namespace ropelight::RL_TARGET {

/// Corners of quads and triangles.
inline std::vector<Vec3> verticesOf(const FlatScene& flat) {
  std::vector<Vec3> v;
  for (const FlatQuad& q : flat.quads)
    for (Vec3d c : q.corner) v.push_back(Vec3(c));
  for (const FlatTriangle& t : flat.triangles)
    for (Vec3d c : {t.a, t.b, t.c}) v.push_back(Vec3(c));
  return v;
}

/// A split plane or the side of a box.
struct AxisPlane {
  int axis;
  float position;
};

/// Makes the rays on which tracers fail, for one scene and the planes of a structure over it.
class RaySet {
 public:
  RaySet(const FlatScene& flat, std::vector<AxisPlane> planes, std::uint32_t seed)
      : flat_(flat), random_(seed), vertices_(verticesOf(flat)), planes_(std::move(planes)) {}

  std::vector<Ray> make(int each) {
    for (int i = 0; i < each; ++i) {
      add(Vec3(random_.inBox(1.5)), Vec3(random_.direction()));
      add(Vec3(random_.inBox(1.5)), alongAxes());
      add(farOrigin(), Vec3(0));
      add(Vec3(random_.inBox(1.5)), uneven());
      if (!planes_.empty()) inPlane();
      if (!vertices_.empty()) atVertices(i);
      if (!flat_.spheres.empty()) aroundSpheres();
      if (flat_.primitiveCount() > 0) onPrimitive();
    }
    return rays_;
  }

 private:
  /// A zero direction stands for one towards the scene.
  void add(Vec3 origin, Vec3 direction) {
    if (direction == Vec3(0)) direction = Vec3(random_.inBox(1)) - origin;
    Real const tMax = random_.below(4) == 0 ? Real(random_.between(0, 3)) : infinity;
    rays_.push_back(Ray{origin, direction, tMax});
  }

  Real signedZero() { return random_.below(2) ? Real(0) : -Real(0); }

  /// Along an axis or in a plane of two, with zeros of either sign.
  Vec3 alongAxes() {
    Vec3 d(random_.direction());
    std::uint32_t const axis = random_.below(3);
    d[int(axis)] = signedZero();
    if (random_.below(2)) d[int((axis + 1) % 3)] = signedZero();
    return d;
  }

  /// Components and lengths from the smallest to the largest that squares allow.
  Vec3 uneven() {
    Vec3 d(random_.direction());
    int const keep = int(random_.below(3));
    for (int a = 0; a < 3; ++a)
      if (a != keep && random_.below(2)) d[a] *= Real(std::pow(10, random_.between(-44, -3)));
    return d * Real(std::pow(10, random_.between(-12, 12)));
  }

  /// As far away as the scene reaches.
  Vec3 farOrigin() {
    Vec3 const extent(flat_.bounds.extent());
    return Vec3(random_.direction()) * (Real(flat_.reach) - (extent.x < 100 ? maxAbs(extent) : Real(0)));
  }

  void inPlane() {
    AxisPlane const plane = planes_[random_.below(planes_.size())];
    Vec3 o(random_.inBox(1.5)), d(random_.direction());
    o[plane.axis] = plane.position;
    d[plane.axis] = signedZero();
    add(o, d);
    d[(plane.axis + 1) % 3] = signedZero();
    add(o, d);
  }

  void atVertices(int i) {
    Vec3 const v = vertices_[random_.below(vertices_.size())], w = vertices_[random_.below(vertices_.size())];
    add(v, Vec3(random_.direction()));
    add(v, alongAxes());
    Vec3 const o(random_.inBox(1.5));
    add(o, v - o);
    if (v != w) add(v, w - v);
    Vec3 const next = vertices_[std::size_t(i) % (vertices_.size() - 1) + 1];
    Vec3 const edge = next - vertices_[std::size_t(i) % (vertices_.size() - 1)];
    if (edge != Vec3(0)) add(next - edge * Real(random_.between(0, 3)), edge);  // along the edge
    add(o, next - edge * Real(random_.unit()) - o);                             // across it
  }

  void aroundSpheres() {
    const FlatSphere& s = flat_.spheres[random_.below(flat_.spheres.size())];
    Vec3d const n = random_.direction(), along = glm::cross(n, random_.direction());
    if (glm::length(along) < 0.01) return;
    add(Vec3(s.center + s.toWorld * (n + random_.between(-3, 3) * along)), Vec3(s.toWorld * along));  // tangent
    add(Vec3(s.center + s.toWorld * (random_.unit() * n)), Vec3(random_.direction()));                // from inside
    add(Vec3(s.center), alongAxes());
  }

  void onPrimitive() {
    std::uint32_t const p = random_.below(flat_.primitiveCount());
    Vec3d const a = surfacePoint(flat_, p, random_), b = surfacePoint(flat_, p, random_);
    add(Vec3(a), Vec3(random_.direction()));
    add(Vec3(a), alongAxes());
    if (Vec3(a) != Vec3(b)) add(Vec3(a), Vec3(b) - Vec3(a));  // within the surface, or through the sphere
  }

  const FlatScene& flat_;
  TestRandom random_;
  std::vector<Vec3> vertices_;
  std::vector<AxisPlane> planes_;
  std::vector<Ray> rays_;
};

inline bool same(const Hit& a, const Hit& b) {
  return a.primitive == b.primitive && a.t == b.t && a.u == b.u && a.v == b.v;
}

/// Counts disagreements and keeps the first for the message.
struct Disagreements {
  int count = 0;
  std::string first;

  void note(bool agree, const char* what, const Ray& r, const Hit& brute, const Hit& found) {
    if (agree || count++ > 0) return;
    char text[512];
    std::snprintf(text, sizeof(text), "%s: o %a %a %a d %a %a %a tMax %g: %g on %d, not %g on %d", what,
                  double(r.origin.x), double(r.origin.y), double(r.origin.z), double(r.direction.x),
                  double(r.direction.y), double(r.direction.z), double(r.tMax), double(brute.t), int(brute.primitive),
                  double(found.t), int(found.primitive));
    first = text;
  }
};

}  // namespace ropelight::RL_TARGET
