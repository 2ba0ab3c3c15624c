#include "measure/rays/stress_rays.h"

#include <cmath>

namespace ropelight {
namespace {

Vec3d cornerOf(const FlatTriangle& t, std::uint32_t i) { return i == 0 ? t.a : (i == 1 ? t.b : t.c); }

/// Where a float vertex is: tracers see no other.
Vec3d rounded(Vec3d v) { return Vec3d(cpu::Vec3(v)); }

}  // namespace

StressRays::StressRays(const FlatScene& scene, const KdTree* tree, std::uint32_t seed) : scene_(scene), engine_(seed) {
  if (tree)
    for (const KdNode& n : tree->nodes)
      if (!n.isLeaf()) planes_.push_back(n);
  center_ = 0.5 * (scene.bounds.min + scene.bounds.max);
  half_ = 0.5 * scene.bounds.extent();
}

std::vector<StreamRay> StressRays::make(std::size_t count) {
  constexpr Kind kinds[] = {&StressRays::scattered,  &StressRays::axisParallel,  &StressRays::fromAfar,
                            &StressRays::uneven,     &StressRays::inPlane,       &StressRays::fromVertex,
                            &StressRays::acrossEdge, &StressRays::throughVertex, &StressRays::alongEdge,
                            &StressRays::inTriangle, &StressRays::fromSurface};
  std::vector<StreamRay> rays(count);
  for (std::size_t i = 0; i < count; ++i) rays[i] = (this->*kinds[i % std::size(kinds)])();
  return rays;
}

std::vector<StreamRay> StressRays::makeInside(std::size_t count, double radius) {
  std::vector<StreamRay> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    const FlatTriangle& t = triangle();
    Vec3d const o = rounded(direction() * (radius * between(0, 1)));
    Vec3d const at = i % 4 == 0 ? t.a : (i % 4 == 1 ? t.a + (t.b - t.a) * between(0, 1) : 0.5 * (t.b + t.c));
    rays[i] = ray(o, i % 4 == 3 ? direction() : rounded(at) - o);
    rays[i].tMax = std::numeric_limits<float>::infinity();
  }
  return rays;
}

StreamRay StressRays::scattered() { return ray(inBox(1.5), direction()); }

StreamRay StressRays::axisParallel() { return ray(inBox(1.5), alongAxes()); }

/// As far away as the scene's reach allows.
StreamRay StressRays::fromAfar() {
  double const largest = std::max(half_.x, std::max(half_.y, half_.z));
  Vec3d const o = center_ + direction() * std::max(0.9 * (scene_.reach - largest), largest);
  return ray(o, inBox(1) - o);
}

/// Components and lengths from the smallest to the largest.
StreamRay StressRays::uneven() {
  Vec3d d = direction();
  int const keep = int(below(3));
  for (int a = 0; a < 3; ++a)
    if (a != keep && below(2)) d[a] *= std::pow(10, between(-44, -3));
  return ray(inBox(1.5), d * std::pow(10, between(-12, 12)));
}

StreamRay StressRays::inPlane() {
  if (planes_.empty()) return axisParallel();
  KdNode const n = planes_[below(planes_.size())];
  Vec3d o = inBox(1.5), d = direction();
  o[int(n.axis())] = double(n.split);
  d[int(n.axis())] = below(2) ? 0.0 : -0.0;
  if (below(2)) d[int(n.axis() + 1) % 3] = 0;
  return ray(o, d);
}

StreamRay StressRays::fromVertex() { return ray(vertex(), below(2) ? direction() : alongAxes()); }

StreamRay StressRays::throughVertex() {
  Vec3d const o = rounded(below(2) ? inBox(1.5) : vertex());
  return ray(o, vertex() - o);
}

StreamRay StressRays::acrossEdge() {
  const FlatTriangle& t = triangle();
  Vec3d const o = rounded(inBox(1.5));
  return ray(o, rounded(t.a + (t.b - t.a) * between(0, 1)) - o);
}

StreamRay StressRays::alongEdge() {
  const FlatTriangle& t = triangle();
  Vec3d const edge = rounded(t.b) - rounded(t.a);
  return ray(rounded(t.a) - edge * between(0, 3), edge);
}

/// Tangent: within the triangle's plane, as far as rounding allows.
StreamRay StressRays::inTriangle() {
  const FlatTriangle& t = triangle();
  Vec3d const d = (t.b - t.a) * between(-1, 1) + (t.c - t.a) * between(-1, 1);
  return ray(t.a + (t.b - t.a) * between(0, 0.5) + (t.c - t.a) * between(0, 0.5) - d * between(0, 3), d);
}

StreamRay StressRays::fromSurface() {
  const FlatTriangle& t = triangle();
  double const u = between(0, 1), v = between(0, 1 - u);
  return ray(t.a + (t.b - t.a) * u + (t.c - t.a) * v, below(2) ? direction() : alongAxes());
}

Vec3d StressRays::inBox(double scale) {
  return center_ + half_ * (scale * Vec3d(between(-1, 1), between(-1, 1), between(-1, 1)));
}

Vec3d StressRays::direction() {
  double const z = between(-1, 1), phi = between(0, 2 * M_PI), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Along an axis or in a plane of two, with zeros of either sign.
Vec3d StressRays::alongAxes() {
  Vec3d d = direction();
  int const axis = int(below(3));
  d[axis] = below(2) ? 0.0 : -0.0;
  if (below(2)) d[(axis + 1) % 3] = below(2) ? 0.0 : -0.0;
  return d;
}

const FlatTriangle& StressRays::triangle() { return scene_.triangles[below(scene_.triangles.size())]; }

Vec3d StressRays::vertex() { return rounded(cornerOf(triangle(), below(3))); }

/// One in four ends within the scene. A direction that rounding has made zero is replaced.
StreamRay StressRays::ray(Vec3d origin, Vec3d d) {
  cpu::Vec3 const o(origin);
  cpu::Vec3 f(d);
  if (!(cpu::maxAbs(f) > 0)) f = cpu::Vec3(0, 0, 1);
  StreamRay r{{o.x, o.y, o.z}, std::numeric_limits<float>::infinity(), {f.x, f.y, f.z}};
  double const extent = std::max(half_.x, std::max(half_.y, half_.z));
  if (below(4) == 0) r.tMax = float(between(0, 2) * extent / double(cpu::maxAbs(f)));
  return r;
}

}  // namespace ropelight
