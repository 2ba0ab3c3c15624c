#include "measure/rays/hit_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropelight {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double leastSlope = 1e-2;  // sine between ray and plane below which a crossing is not clear

Vec3d originOf(const StreamRay& r) { return {r.origin[0], r.origin[1], r.origin[2]}; }
Vec3d directionOf(const StreamRay& r) { return {r.direction[0], r.direction[1], r.direction[2]}; }

double distanceToSegment(Vec3d p, Vec3d a, Vec3d b) {
  Vec3d const e = b - a;
  double const ee = glm::dot(e, e);
  double const s = ee > 0 ? std::clamp(glm::dot(p - a, e) / ee, 0.0, 1.0) : 0;
  return glm::length(p - (a + e * s));
}

double distanceToTriangle(Vec3d p, const FlatTriangle& t) {
  Vec3d const n = glm::cross(t.b - t.a, t.c - t.a);
  double const nn = glm::dot(n, n);
  double const edges = std::min(distanceToSegment(p, t.a, t.b),
                                std::min(distanceToSegment(p, t.b, t.c), distanceToSegment(p, t.c, t.a)));
  if (!(nn > 0)) return edges;
  auto const inner = [&](Vec3d a, Vec3d b) { return glm::dot(glm::cross(b - a, p - a), n) >= 0; };
  bool const above = inner(t.a, t.b) && inner(t.b, t.c) && inner(t.c, t.a);
  return above ? std::abs(glm::dot(p - t.a, n)) / std::sqrt(nn) : edges;
}

}  // namespace

HitJudge::HitJudge(const FlatScene& scene) : scene_(scene), tolerance_(std::ldexp(scene.reach, -18)) {}

bool HitJudge::acceptable(const StreamRay& ray, const StreamHit& answer, std::span<const StreamHit> candidates) const {
  if (answer.found() && !liesOn(ray, answer)) return false;
  double const slack = tolerance_ / glm::length(directionOf(ray)) / leastSlope;
  double const limit = answer.found() ? double(answer.t) : double(ray.tMax);
  return std::none_of(candidates.begin(), candidates.end(),
                      [&](const StreamHit& c) { return c.found() && crossing(ray, c.primitive) < limit - slack; });
}

FlatTriangle HitJudge::triangle(std::uint32_t primitive) const {
  const FlatTriangle& t = scene_.triangles[primitive - (scene_.quads.size() + scene_.spheres.size())];
  return {Vec3d(cpu::Vec3(t.a)), Vec3d(cpu::Vec3(t.b)), Vec3d(cpu::Vec3(t.c))};
}

bool HitJudge::liesOn(const StreamRay& ray, const StreamHit& hit) const {
  Vec3d const p = originOf(ray) + double(hit.t) * directionOf(ray);
  return distanceToTriangle(p, triangle(hit.primitive)) <= tolerance_;
}

double HitJudge::crossing(const StreamRay& ray, std::uint32_t primitive) const {
  FlatTriangle const t = triangle(primitive);
  Vec3d const o = originOf(ray), d = directionOf(ray), n = glm::cross(t.b - t.a, t.c - t.a);
  double const slope = glm::dot(n, d), steepest = glm::length(n) * glm::length(d);
  if (!(std::abs(slope) > leastSlope * steepest)) return never;
  double const at = glm::dot(t.a - o, n) / slope;
  Vec3d const p = o + at * d;
  for (auto [a, b] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
    double const inside = glm::dot(glm::cross(b - a, p - a), n) / (glm::length(n) * glm::length(b - a));
    if (!(inside > tolerance_ / leastSlope)) return never;
  }
  return at * glm::length(d) > tolerance_ / leastSlope ? at : never;
}

}  // namespace ropelight
