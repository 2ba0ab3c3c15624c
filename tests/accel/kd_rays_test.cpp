// Rays through the tree against testing every primitive: the same primitive at the same distance, bit for bit.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "render/flatten/flatten.h"
#include "render/intersection/intersect.h"
#include "tests/scenes/adversarial_rays.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr FeatureBits treeOnly = feature::all;
constexpr FeatureBits bruteForce = feature::all & ~feature::tree;

std::vector<AxisPlane> splitPlanes(const KdTree& tree) {
  std::vector<AxisPlane> planes;
  for (const KdNode& n : tree.nodes)
    if (!n.isLeaf()) planes.push_back({int(n.axis()), n.split});
  return planes;
}

/// What testing every primitive says of a ray.
struct Expected {
  Ray ray;
  Hit hit;
  bool anyOther = false;  ///< whether anything but the closest primitive is hit

  Expected(const SceneView& scene, const Ray& r) : ray(r), hit(closestHitBruteForce<bruteForce>(scene, r)) {
    if (hit.found()) anyOther = occluded<bruteForce>(scene, r, hit.primitive);
  }
};

/// Everything that a ray may be asked.
void compare(const SceneView& scene, const Expected& expected, Disagreements& wrong) {
  Ray ray = expected.ray;
  const Hit& brute = expected.hit;
  Hit const tree = closestHit<treeOnly>(scene, ray);
  wrong.note(same(tree, brute), "closest", ray, brute, tree);
  wrong.note(occluded<treeOnly>(scene, ray, noPrimitive) == brute.found(), "any", ray, brute, tree);
  if (!brute.found()) return;
  wrong.note(occluded<treeOnly>(scene, ray, brute.primitive) == expected.anyOther, "any but one", ray, brute, tree);
  ray.tMax = brute.t;
  Hit const atEnd = closestHit<treeOnly>(scene, ray);
  wrong.note(same(atEnd, brute), "at tMax", ray, brute, atEnd);
  ray.tMax = std::nextafter(brute.t, Real(0));
  wrong.note(!closestHit<treeOnly>(scene, ray).found(), "before the hit", ray, brute, tree);
}

std::vector<FlatTriangle> closedBall() { return bumpyBall(50, 51); }

}  // namespace

TEST_CASE("the tree finds what testing every primitive finds, whatever the ray and the tree") {
  for (const GeometryScene& scene : geometryScenes()) {
    CAPTURE(scene.name);
    HostScene const reference(scene.flat, KdConfig{});
    std::vector<Expected> expected;
    int hits = 0;
    int const each = scene.flat.primitiveCount() > 1000 ? 60 : 250;
    for (const Ray& r : RaySet(scene.flat, splitPlanes(reference.tree()), 41).make(each)) {
      expected.emplace_back(reference.view(), r);
      hits += expected.back().hit.found();
    }
    CHECK((hits > 100 || scene.flat.bounds.extent() == Vec3d(0) || scene.flat.primitiveCount() == 0));
    for (const TreeConfig& c : treeConfigs()) {
      CAPTURE(c.name);
      HostScene const host(scene.flat, c.config);
      Disagreements wrong;
      for (const Expected& e : expected) compare(host.view(), e, wrong);
      CAPTURE(wrong.first);
      CHECK(wrong.count == 0);
    }
  }
}

TEST_CASE("hits lie on their primitives, in front of the origin") {
  for (const GeometryScene& scene : geometryScenes()) {
    CAPTURE(scene.name);
    HostScene const host(scene.flat, KdConfig{});
    TestRandom random(43);
    int behind = 0, nan = 0;
    double off = 0;
    for (int i = 0; i < 2000; ++i) {
      Ray const ray{Vec3(random.inBox(1.5)), Vec3(random.direction())};
      Hit const hit = closestHit<treeOnly>(host.view(), ray);
      if (!hit.found()) continue;
      behind += !(hit.t > 0);
      Surface const s = surfaceAt<treeOnly>(host.view(), ray, hit);
      nan += !isFinite(s.p) || !isFinite(s.n) || !isFinite(s.error);
      // A grazing hit slides along its surface: the distance counts across it.
      Vec3d const d = Vec3d(s.p) - (Vec3d(ray.origin) + double(hit.t) * Vec3d(ray.direction));
      off = std::max(off, std::abs(glm::dot(d, Vec3d(s.n))));
    }
    CHECK(behind == 0);
    CHECK(nan == 0);
    CHECK(off < 2e-6);
  }
}

TEST_CASE("no ray escapes from a closed mesh, through edges and vertices neither") {
  FlatScene const flat = flatten(SceneBuilder().mesh(closedBall()).scene);
  HostScene const host(flat, KdConfig{});
  TestRandom random(44);
  int escaped = 0;
  for (int i = 0; i < 20000; ++i) {
    const FlatTriangle& t = flat.triangles[random.below(flat.triangles.size())];
    Vec3 const o(random.inBox(0.4)), a(t.a), b(t.b);
    Vec3 const at = i % 3 == 0 ? a : i % 3 == 1 ? a + (b - a) * Real(random.unit()) : Real(0.5) * (a + b);
    escaped += !closestHit<treeOnly>(host.view(), Ray{o, at - o}).found();
    escaped += !closestHit<treeOnly>(host.view(), Ray{o, Vec3(random.direction())}).found();
  }
  CHECK(escaped == 0);
}

TEST_CASE("no ray escapes from a closed box, through edges and corners neither") {
  TestRandom random(45);
  for (int box = 0; box < 20; ++box) {
    Mat4d const m = box == 0 ? Mat4d(1.0) : randomPlace(random) * scaling({1, random.between(0.1, 1), 0.5});
    FlatScene const flat = flatten(SceneBuilder().add(ShapeKind::box, m).scene);
    HostScene const host(flat, KdConfig{});
    int escaped = 0;
    for (int i = 0; i < 2000; ++i) {
      const FlatQuad& q = flat.quads[random.below(6)];
      int const k = int(random.below(4));
      Vec3 const o(transformPoint(m, random.inBox(0.98))), a(q.corner[k]), b(q.corner[(k + 1) % 4]);
      for (Vec3 at : {a, a + (b - a) * Real(random.unit()), Real(0.5) * (a + Vec3(q.corner[(k + 2) % 4]))}) {
        escaped += !closestHitBruteForce<bruteForce>(host.view(), Ray{o, at - o}).found();
        escaped += !closestHit<treeOnly>(host.view(), Ray{o, at - o}).found();
      }
    }
    CHECK(escaped == 0);
  }
}

TEST_CASE("no ray escapes from within an ellipsoid") {
  TestRandom random(46);
  for (Vec3d axes : {Vec3d(1, 1, 1), Vec3d(1, 0.1, 0.3), Vec3d(1e-3, 1, 1), Vec3d(1e4, 1e4, 1e4)}) {
    Mat4d const m = randomPlace(random) * scaling(axes);
    HostScene const host(flatten(SceneBuilder().add(ShapeKind::sphere, m).scene), KdConfig{});
    int escaped = 0;
    for (int i = 0; i < 5000; ++i) {
      Vec3 const o(transformPoint(m, random.direction() * random.between(0, 0.99)));
      escaped += !closestHit<treeOnly>(host.view(), Ray{o, Vec3(random.direction())}).found();
    }
    CHECK(escaped == 0);
  }
}
