// Rays through the tree against testing every primitive: the same primitive at the same distance, bit for bit.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "accel/intersect.h"
#include "tests/geometry_scenes.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr FeatureBits treeOnly = feature::all;
constexpr FeatureBits bruteForce = feature::all & ~feature::tree;

/// Corners of quads and triangles.
std::vector<Vec3> verticesOf(const FlatScene& flat) {
  std::vector<Vec3> v;
  for (const FlatQuad& q : flat.quads)
    for (Vec3d c : q.corner) v.push_back(Vec3(c));
  for (const FlatTriangle& t : flat.triangles)
    for (Vec3d c : {t.a, t.b, t.c}) v.push_back(Vec3(c));
  return v;
}

/// Makes the rays on which tracers fail, for one scene.
class RaySet {
 public:
  RaySet(const FlatScene& flat, const KdTree& tree, std::uint32_t seed)
      : flat_(flat), random_(seed), vertices_(verticesOf(flat)) {
    for (const KdNode& n : tree.nodes)
      if (!n.isLeaf()) splits_.push_back(n);
  }

  std::vector<Ray> make(int each) {
    for (int i = 0; i < each; ++i) {
      add(Vec3(random_.inBox(1.5)), Vec3(random_.direction()));
      add(Vec3(random_.inBox(1.5)), alongAxes());
      add(farOrigin(), Vec3(0));
      add(Vec3(random_.inBox(1.5)), uneven());
      if (!splits_.empty()) inSplitPlane();
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

  void inSplitPlane() {
    KdNode const n = splits_[random_.below(splits_.size())];
    Vec3 o(random_.inBox(1.5)), d(random_.direction());
    o[int(n.axis())] = n.split;
    d[int(n.axis())] = signedZero();
    add(o, d);
    d[int((n.axis() + 1) % 3)] = signedZero();
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
  std::vector<KdNode> splits_;
  std::vector<Ray> rays_;
};

bool same(const Hit& a, const Hit& b) { return a.primitive == b.primitive && a.t == b.t && a.u == b.u && a.v == b.v; }

/// Counts disagreements and keeps the first for the message.
struct Disagreements {
  int count = 0;
  std::string first;

  void note(bool agree, const char* what, const Ray& r, const Hit& brute, const Hit& tree) {
    if (agree || count++ > 0) return;
    char text[512];
    std::snprintf(text, sizeof(text), "%s: o %a %a %a d %a %a %a tMax %g: %g on %d, tree %g on %d", what,
                  double(r.origin.x), double(r.origin.y), double(r.origin.z), double(r.direction.x),
                  double(r.direction.y), double(r.direction.z), double(r.tMax), double(brute.t), int(brute.primitive),
                  double(tree.t), int(tree.primitive));
    first = text;
  }
};

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
    for (const Ray& r : RaySet(scene.flat, reference.tree(), 41).make(each)) {
      expected.emplace_back(reference.view(), r);
      hits += expected.back().hit.found();
    }
    CHECK((hits > 100 || scene.flat.primitiveCount() == 0));
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
