// Meshes kept once and placed: the same surfaces as triangles in the world, whatever the transform and the structure.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "render/flatten/flatten.h"
#include "render/intersection/intersect.h"
#include "render/kernels/frame_view.h"
#include "tests/scenes/adversarial_rays.h"
#include "tests/scenes/placed_meshes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr FeatureBits bruteForce =
    feature::quads | feature::spheres | feature::triangles | feature::instances | feature::bvh;
constexpr FeatureBits everything = feature::all;

/// The number in the scene with every mesh in the world of a hit in the one with every mesh placed.
std::uint32_t inWorld(const FlatScene& instanced, std::uint32_t hit) {
  std::uint32_t const others = std::uint32_t(instanced.quads.size() + instanced.spheres.size());
  return hit < instanced.primitiveCount() ? hit : hit - instanced.primitiveCount() + others;
}

std::vector<AxisPlane> sides(const Bvh<2>& bvh) {
  std::vector<AxisPlane> planes;
  for (const BvhNode<2>& n : bvh.nodes)
    for (int a = 0; a < 3; ++a)
      for (int k = 0; k < 2; ++k) planes.push_back({a, n.min[a][k]});
  return planes;
}

std::vector<Ray> raysFor(const FlatScene& baked, const HostScene& instanced, int each) {
  return RaySet(baked, sides(instanced.bvh()), 63).make(each);
}

/// A structure over the scene and its meshes, as a pair of questions.
struct Tracer {
  const char* name;
  std::function<Hit(const Ray&)> closest;
  std::function<bool(const Ray&)> any;
};

Tracer tracer(const char* name, const SceneView& view) {
  return {name, [&view](const Ray& r) { return closestHit<everything>(view, r); },
          [&view](const Ray& r) { return occluded<everything>(view, r, noPrimitive); }};
}

Tracer binaryTracer(const HostScene& host) {
  BvhView<2> const bvh{{host.bvh().nodes.data(), std::uint32_t(host.bvh().nodes.size())}, host.view().bvh.items};
  const SceneView& view = host.view();
  return {"binary", [&view, bvh](const Ray& r) { return closestHitBvh<everything>(view, bvh, r); },
          [&view, bvh](const Ray& r) { return occludedBvh<everything>(view, bvh, r, noPrimitive); }};
}

void compare(const Tracer& tracer, Ray ray, const Hit& brute, Disagreements& wrong) {
  Hit const found = tracer.closest(ray);
  wrong.note(same(found, brute), "closest", ray, brute, found);
  wrong.note(tracer.any(ray) == brute.found(), "any", ray, brute, found);
  if (!brute.found()) return;
  ray.tMax = brute.t;
  wrong.note(same(tracer.closest(ray), brute) && tracer.any(ray), "at tMax", ray, brute, found);
  ray.tMax = std::nextafter(brute.t, Real(0));
  wrong.note(!tracer.closest(ray).found() && !tracer.any(ray), "before the hit", ray, brute, found);
}

/// Distance of a point from the plane of a triangle, and the triangle's normal.
struct Plane {
  Vec3d n;
  double at;
  explicit Plane(const FlatTriangle& t) : n(glm::normalize(glm::cross(t.b - t.a, t.c - t.a))), at(glm::dot(n, t.a)) {}
  double distance(Vec3 p) const { return std::abs(glm::dot(n, Vec3d(p)) - at); }
};

double nearEdge(const Hit& h) { return double(std::min({h.u, h.v, 1 - h.u - h.v})); }

/// A ball that is convex, in 2·segments·(rows − 1) triangles.
std::vector<FlatTriangle> roundBall() {
  std::vector<FlatTriangle> ball = bumpyBall(20, 15);
  for (FlatTriangle& t : ball)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) *p = glm::normalize(*p);
  return ball;
}

}  // namespace

TEST_CASE("every structure finds in placed meshes what testing every triangle finds") {
  for (const Scene& scene : {placedBalls(), placed(scattered(64, 60, 0.8))}) {
    FlatScene const flat = flatten(scene, Instancing::always), baked = flatten(scene, Instancing::never);
    REQUIRE(flat.instances.size() == 12);
    HostScene const ropes(flat, KdConfig{}), stack(flat, KdConfig{}, true), bvh(flat, BvhConfig{});
    Disagreements wrong;
    int placedHits = 0;
    for (const Ray& ray : raysFor(baked, bvh, 120)) {
      Hit const brute = closestHitBruteForce<bruteForce>(ropes.view(), ray);
      placedHits += brute.found() && brute.primitive >= flat.primitiveCount();
      wrong.note(occludedBruteForce<bruteForce>(ropes.view(), ray, noPrimitive) == brute.found(), "brute", ray, brute,
                 brute);
      for (const Tracer& t : {tracer("ropes", ropes.view()), tracer("short stack", stack.view()),
                              tracer("wide", bvh.view()), binaryTracer(bvh)})
        compare(t, ray, brute, wrong);
    }
    CHECK(placedHits > 200);
    CAPTURE(wrong.first);
    CHECK(wrong.count == 0);
  }
}

TEST_CASE("a placed mesh is hit where its triangles in the world are") {
  Scene const scene = placedBalls();
  FlatScene const flat = flatten(scene, Instancing::always), baked = flatten(scene, Instancing::never);
  HostScene const instanced(flat, BvhConfig{}), reference(baked, BvhConfig{});
  int hits = 0, disputed = 0, unexplained = 0, off = 0, turned = 0, elsewhere = 0;
  for (const Ray& ray : raysFor(baked, instanced, 600)) {
    Hit const a = closestHit<everything>(instanced.view(), ray), b = closestHit<everything>(reference.view(), ray);
    std::uint32_t const id = a.found() ? inWorld(flat, a.primitive) : noPrimitive;
    if (id != b.primitive) {  // rounding decides at edges and where a surface is grazed or begins
      ++disputed;
      const Hit& nearer = !b.found() || (a.found() && a.t < b.t) ? a : b;
      Surface const s = &nearer == &a ? surfaceAt<everything>(instanced.view(), ray, a)
                                      : surfaceAt<everything>(reference.view(), ray, b);
      bool const atStart = double(nearer.t) * glm::length(Vec3d(ray.direction)) < 1e-5;
      bool const grazing = std::abs(dot(s.n, normalize(ray.direction))) < 1e-3f;
      bool const atEnd = std::abs(nearer.t - ray.tMax) <= 1e-5f * ray.tMax;
      bool const tie = a.found() && b.found() && std::abs(a.t - b.t) <= 1e-5f * b.t;
      unexplained += !(nearEdge(nearer) < 1e-3 || atStart || grazing || atEnd || tie);
      continue;
    }
    if (!a.found() || a.primitive < flat.primitiveCount()) continue;
    ++hits;
    std::size_t const others = flat.quads.size() + flat.spheres.size();
    Plane const plane(baked.triangles[id - others]);
    Surface const s = surfaceAt<everything>(instanced.view(), ray, a),
                  r = surfaceAt<everything>(reference.view(), ray, b);
    Vec3d const n = glm::abs(plane.n);
    off += plane.distance(s.p) > glm::dot(n, Vec3d(s.error));
    turned += glm::length(Vec3d(s.n) - plane.n) > 2e-5;
    double const cosine = std::abs(glm::dot(plane.n, Vec3d(ray.direction)));
    double const moved = double(a.t) * 1e-6 * glm::length(Vec3d(ray.direction)) + glm::dot(n, Vec3d(s.error + r.error));
    elsewhere += !(std::abs(double(a.t) - double(b.t)) * cosine <= moved);
    CHECK(s.material == r.material);
    CHECK(s.primitive == a.primitive);
  }
  CHECK(hits > 2000);
  CHECK(disputed < hits / 5);
  CHECK(unexplained == 0);
  CHECK(off == 0);
  CHECK(turned == 0);
  CHECK(elsewhere == 0);
}

TEST_CASE("rays that leave a placed mesh start on their side of it, at any scale") {
  for (double size : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (const Place& place : places(size)) {
      CAPTURE(size);
      CAPTURE(place.name);
      SceneBuilder b;
      b.mesh(roundBall(), place.toWorld).cameraAt(Vec3d(5, 5, 5) * size);
      FlatScene const flat = flatten(b.scene, Instancing::always);
      REQUIRE(flat.instances.size() == 1);
      HostScene const host(flat, BvhConfig{});
      TestRandom random(65);
      int missed = 0, back = 0, escaped = 0, wrongSide = 0;
      Vec3d const middle = transformPoint(place.toWorld, Vec3d(0));
      FlatScene const baked = flatten(b.scene, Instancing::never);
      for (int i = 0; i < 300; ++i) {
        Ray const ray{Vec3(middle + random.inBox(0.01 * size)), Vec3(random.direction())};
        Hit const hit = closestHit<everything>(host.view(), ray);
        if (!hit.found()) {
          ++missed;
          continue;
        }
        Surface const s = surfaceAt<everything>(host.view(), ray, hit);
        wrongSide += !(dot(s.n, ray.direction) > 0);
        Plane const plane(baked.triangles[hit.primitive - flat.primitiveCount()]);
        Vec3 w(random.direction());
        if (std::abs(dot(w, s.n)) < 0.05f) continue;
        if (dot(w, s.n) < 0) w = -w;
        Ray const out = depart<everything>(host.view(), s, w).ray, in = depart<everything>(host.view(), s, -w).ray;
        wrongSide += glm::dot(plane.n, Vec3d(out.origin)) < plane.at || glm::dot(plane.n, Vec3d(in.origin)) > plane.at;
        back += occluded<everything>(host.view(), out, noPrimitive);
        escaped += !closestHit<everything>(host.view(), in).found();
      }
      CHECK(missed == 0);
      CHECK(back == 0);
      CHECK(escaped == 0);
      CHECK(wrongSide == 0);
    }
}

TEST_CASE("no ray escapes from a closed placed mesh, through edges and vertices neither") {
  std::vector<FlatTriangle> const ball = bumpyBall(30, 31);
  for (const Place& place : places(1)) {
    CAPTURE(place.name);
    FlatScene const flat = flatten(SceneBuilder().mesh(ball, place.toWorld).scene, Instancing::always);
    HostScene const ropes(flat, KdConfig{}), bvh(flat, BvhConfig{});
    TestRandom random(66);
    int escaped = 0;
    for (int i = 0; i < 1500; ++i) {
      const FlatTriangle& t = ball[random.below(ball.size())];
      Vec3d const on = i % 3 == 0 ? t.a : i % 3 == 1 ? t.a + (t.b - t.a) * random.unit() : 0.5 * (t.a + t.b);
      Vec3 const o(transformPoint(place.toWorld, random.inBox(0.4))), at(transformPoint(place.toWorld, on));
      for (const Ray& ray : {Ray{o, at - o}, Ray{o, Vec3(random.direction())}}) {
        escaped += !closestHit<everything>(ropes.view(), ray).found();
        escaped += !closestHit<everything>(bvh.view(), ray).found();
        escaped += !occluded<everything>(bvh.view(), ray, noPrimitive);
      }
    }
    CHECK(escaped == 0);
  }
}

TEST_CASE("small placed meshes are hit from afar as the ray goes") {
  SceneBuilder b;
  b.mesh(roundBall(), scaling(Vec3d(1e-3))).cameraAt({10, 0, 0});
  FlatScene const flat = flatten(b.scene, Instancing::always);
  HostScene const ropes(flat, KdConfig{}), bvh(flat, BvhConfig{});
  TestRandom random(67);
  Disagreements wrong;
  int hits = 0, away = 0;
  for (int i = 0; i < 2000; ++i) {
    Vec3 const o(random.direction() * random.between(0.01, 9)), at(random.inBox(1e-3));
    Ray const ray{o, normalize(at - o)};
    Hit const brute = closestHitBruteForce<bruteForce>(bvh.view(), ray);
    for (const Tracer& t : {tracer("ropes", ropes.view()), tracer("wide", bvh.view())}) compare(t, ray, brute, wrong);
    if (!brute.found()) continue;
    ++hits;
    double const distance = glm::length(Vec3d(o) + double(brute.t) * Vec3d(ray.direction));
    away += std::abs(distance - 1e-3) > 2e-5 + 4e-7 * double(brute.t);  // facets are that far inside the sphere
  }
  CHECK(hits > 500);
  CHECK(away == 0);
  CAPTURE(wrong.first);
  CHECK(wrong.count == 0);
}

TEST_CASE("placed meshes are lit as their triangles in the world") {
  Scene kept = testing::emptyScene(0.7f);
  testing::addQuad(kept, {-3, -1, 3}, {6, 0, 0}, {0, 0, -6});
  testing::addQuad(kept, {-1, 3, 1}, {2, 0, 0}, {0, 0, -2}).emission = Emission{Rgb(8.0f), Side::both};
  kept.meshes.push_back(SceneBuilder().mesh(bumpyBall(20, 31)).scene.meshes[0]);
  Scene copied = kept;
  copied.meshes.push_back(copied.meshes[0]);
  int const mirror = testing::addMaterial(kept, MirrorParams{});
  testing::addMaterial(copied, MirrorParams{});
  for (int i = 0; i < 2; ++i)
    for (Scene* scene : {&kept, &copied}) {
      ShapeDesc& shape = scene->shapes.emplace_back();
      shape.kind = ShapeKind::mesh;
      shape.mesh = scene == &kept ? 0 : i;
      shape.material = i == 0 ? 0 : mirror;
      shape.toWorld = translation({2.0 * i - 1, 0, 0}) * rotation({1, 2, 3}, 70) * scaling({0.8, i ? -0.4 : 0.9, 0.7});
    }
  for (Scene* scene : {&kept, &copied}) testing::lookAt(*scene, {0, 1, 7}, {0, 0, 0}, {0, 1, 0}, 40);
  for (Mode const mode : {Mode::path, Mode::sppm}) {
    CAPTURE(nameOf(mode));
    Settings settings = testing::settingsFor(mode, 48, 32);
    settings.photons = 4000;
    settings.radius = 0.2;
    Stats stats, statsOfCopies;
    Image const a = testing::renderImage(kept, settings, 8, &stats);
    Image const b = testing::renderImage(copied, settings, 8, &statsOfCopies);
    CHECK(stats.kernelRow == "full");
    CHECK(statsOfCopies.kernelRow == "mesh");
    CHECK(stats.accel == "bvh");
    CHECK(stats.nonFinite == 0);
    int close = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
      close += maxComponent(glm::abs(a.pixels[i] - b.pixels[i])) <= 1e-3f * (1 + maxComponent(b.pixels[i]));
    CHECK(close > int(a.pixels.size()) * 95 / 100);  // rounding may send single paths elsewhere
    CHECK(testing::meanOf(a) == doctest::Approx(testing::meanOf(b)).epsilon(0.01));
    CHECK(testing::meanOf(a) > 0.05);
    settings.accel = Accel::tree;
    settings.seed = 2;
    CHECK(testing::meanOf(testing::renderImage(kept, settings, 8)) ==
          doctest::Approx(testing::meanOf(a)).epsilon(0.05));
  }
}
