// Rays through the wide hierarchy against testing every primitive: the same primitive at the same distance, bit for
// bit.

#include <doctest/doctest.h>

#include <cmath>

#include "accel/bvh/traverse_wide.h"
#include "tests/scenes/adversarial_rays.h"
#include "tests/scenes/bvh_scenes.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr FeatureBits bruteForce = feature::quads | feature::spheres | feature::triangles | feature::bvh;

/// Rays through one hierarchy as the renderer traces them, primitive by primitive.
class WideTracer {
 public:
  WideTracer(const SceneView& scene, const Bvh<4>& bvh)
      : scene_(scene),
        view_{{bvh.nodes.data(), std::uint32_t(bvh.nodes.size())},
              {bvh.items.data(), std::uint32_t(bvh.items.size())}} {}

  Hit closest(const Ray& ray) const {
    return trace(ray, noPrimitive, [](const Hit& hit) { return hit.t; });
  }
  bool any(const Ray& ray, std::uint32_t ignored) const {
    return trace(ray, ignored, [](const Hit& hit) { return hit.found() ? Real(-1) : hit.t; }).found();
  }

 private:
  template <class Limit>
  Hit trace(const Ray& ray, std::uint32_t ignored, const Limit& limit) const {
    Hit hit;
    hit.t = ray.tMax;
    RayShear const shear(ray);
    auto const test = [&](std::uint32_t item) {
      std::uint32_t const id = view_.items[item];
      if (id != ignored) intersectPrimitive<bruteForce>(scene_, ray, shear, id, hit);
    };
    traverseWide(
        view_, ray, test, [&] { return limit(hit); }, [] {});
    return hit;
  }

  const SceneView& scene_;
  BvhView<4> view_;
};

std::vector<AxisPlane> sides(const Bvh<4>& bvh) {
  std::vector<AxisPlane> planes;
  for (const BvhNode<4>& n : bvh.nodes)
    for (int a = 0; a < 3; ++a)
      for (int k = 0; k < 4; ++k)
        if (!n.child[k].none()) {
          planes.push_back({a, n.min[a][k]});
          planes.push_back({a, n.max[a][k]});
        }
  return planes;
}

Vec3d inDouble(Vec3 v) { return Vec3d(double(v.x), double(v.y), double(v.z)); }

/// Seen edge-on, a quad or a needle is hit at a distance whose error grows with 1/cos: by more than the boxes are
/// padded, the hit may lie before the ray enters the box, which a walk that ends at the hit need not visit. Quads that
/// are grazed are moved into their box; those seen at a few degrees are not.
bool distanceUncertain(const SceneView& scene, const Ray& ray, const Hit& hit, double pad) {
  Vec3d const o = inDouble(ray.origin), d = inDouble(ray.direction);
  Vec3d a, n;
  std::uint32_t const firstTriangle = scene.quads.size + scene.spheres.size;
  if (hit.primitive < scene.quads.size) {
    const Quad& q = scene.quads[hit.primitive];
    if (abs(dot(q.n, ray.direction)) < grazingCosine * maxAbs(ray.direction)) return false;
    a = inDouble(q.a);
    n = glm::cross(inDouble(q.b) - a, inDouble(q.d) - a);
  } else if (hit.primitive >= firstTriangle) {
    const Triangle& t = scene.triangles[hit.primitive - firstTriangle];
    a = inDouble(t.a);
    n = glm::cross(inDouble(t.b) - a, inDouble(t.c) - a);
  } else {
    return false;
  }
  double const exact = glm::dot(n, a - o) / glm::dot(n, d);
  return !(std::abs(exact - double(hit.t)) * glm::length(d) < pad);
}

void compare(const WideTracer& tracer, Ray ray, const Hit& brute, bool anyOther, bool uncertain, Disagreements& wrong) {
  Hit const found = tracer.closest(ray);
  wrong.note(same(found, brute), "closest", ray, brute, found);
  wrong.note(tracer.any(ray, noPrimitive) == brute.found(), "any", ray, brute, found);
  if (!brute.found()) return;
  wrong.note(tracer.any(ray, brute.primitive) == anyOther, "any but one", ray, brute, found);
  if (uncertain) return;
  ray.tMax = brute.t;
  Hit const atEnd = tracer.closest(ray);
  wrong.note(same(atEnd, brute), "at tMax", ray, brute, atEnd);
  ray.tMax = std::nextafter(brute.t, Real(0));
  wrong.note(!tracer.closest(ray).found(), "before the hit", ray, brute, found);
}

void compareAll(const GeometryScene& scene, int each) {
  CAPTURE(scene.name);
  HostScene const host(scene.flat);
  std::vector<Bvh<4>> hierarchies;
  for (const NamedConfig& c : bvhConfigs()) hierarchies.push_back(widen(buildBvh(scene.flat, c.config)));
  std::vector<Disagreements> wrong(hierarchies.size());
  double const pad = std::ldexp(scene.flat.reach, -20);  // of the hierarchy's boxes
  int hits = 0, uncertain = 0;
  for (const Ray& ray : RaySet(scene.flat, sides(hierarchies[0]), 53).make(each)) {
    Hit const brute = closestHitBruteForce<bruteForce>(host.view(), ray);
    hits += brute.found();
    bool const other = brute.found() && occluded<bruteForce>(host.view(), ray, brute.primitive);
    bool const doubtful = brute.found() && distanceUncertain(host.view(), ray, brute, pad);
    uncertain += doubtful;
    for (std::size_t i = 0; i < hierarchies.size(); ++i)
      compare(WideTracer(host.view(), hierarchies[i]), ray, brute, other, doubtful, wrong[i]);
  }
  CHECK((hits > 50 || scene.flat.bounds.extent() == Vec3d(0)));
  CHECK(uncertain <= hits / 3);  // few but for needles
  for (std::size_t i = 0; i < hierarchies.size(); ++i) {
    CAPTURE(bvhConfigs()[i].name);
    CAPTURE(wrong[i].first);
    CHECK(wrong[i].count == 0);
  }
}

}  // namespace

TEST_CASE("rays through the wide hierarchy find what testing every primitive finds") {
  for (const GeometryScene& scene : geometryScenes())
    if (scene.flat.primitiveCount() > 0) compareAll(scene, scene.flat.primitiveCount() > 1000 ? 20 : 100);
}

TEST_CASE("rays through degenerate hierarchies find what testing every primitive finds") {
  for (const GeometryScene& scene : hardScenes())
    if (scene.name == "chain" || scene.name == "needles") compareAll(scene, 80);
}

TEST_CASE("more rays through the wide hierarchy" * doctest::test_suite("slow")) {
  for (const GeometryScene& scene : geometryScenes())
    if (scene.flat.primitiveCount() > 0) compareAll(scene, scene.flat.primitiveCount() > 1000 ? 300 : 3000);
}

TEST_CASE("a quad that is grazed is hit within its box") {
  TestRandom random(47);
  int hits = 0, outside = 0;
  for (int i = 0; i < 20000; ++i) {
    Vec3 const a(random.inBox(1)), e(random.direction()), f(random.direction());
    Quad const quad{a, a + e, a + e + f, a + f, normalize(cross(e, f))};
    // From afar towards a point of the quad, at angles down to a rounding.
    Vec3 const at = a + Real(random.unit()) * e + Real(random.unit()) * f;
    Vec3 const d = Real(random.between(-1, 1)) * e + Real(random.between(-1, 1)) * f +
                   Real(std::pow(10, random.between(-8, -2))) * quad.n;
    Ray const ray{at - Real(3) * d, d};
    Hit hit;
    intersect(quad, ray, RayShear(ray), 0, hit);
    if (!hit.found()) continue;
    ++hits;
    Vec3d const p = inDouble(ray.origin) + double(hit.t) * inDouble(d);
    double const rounding = 2e-6;
    for (int k = 0; k < 3; ++k) {
      auto const [least, most] = std::minmax({quad.a[k], quad.b[k], quad.c[k], quad.d[k]});
      outside += p[k] < double(least) - rounding || p[k] > double(most) + rounding;
    }
  }
  CHECK(hits > 10000);
  CHECK(outside == 0);
}
