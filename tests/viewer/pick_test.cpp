// What lies under the cursor: closed forms, and the renderer's own rays.

#include <doctest/doctest.h>

#include <cmath>

#include "app/viewer/camera/pick.h"
#include "render/flatten/flatten.h"
#include "render/intersection/intersect.h"
#include "tests/scenes/geometry_scenes.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::view;

namespace {

Scene one(ShapeKind kind, const Mat4d& toWorld) { return SceneBuilder().add(kind, toWorld).scene; }

double hit(const Scene& scene, Vec3d origin, Vec3d direction) {
  auto const found = pick(scene, origin, glm::normalize(direction));
  return found ? found->distance : -1;
}

/// By primitive of the flat scene: quads and boxes first, then spheres, then meshes.
std::vector<int> shapeOfPrimitive(const Scene& scene) {
  std::vector<int> owner;
  auto const add = [&](auto faces) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) owner.insert(owner.end(), faces(scene.shapes[i]), int(i));
  };
  add([](const ShapeDesc& s) { return s.kind == ShapeKind::quad ? 1u : s.kind == ShapeKind::box ? 6u : 0u; });
  add([](const ShapeDesc& s) { return s.kind == ShapeKind::sphere ? 1u : 0u; });
  add([&](const ShapeDesc& s) {
    return s.kind == ShapeKind::mesh ? scene.meshes[std::size_t(s.mesh)].triangles.size() : 0u;
  });
  return owner;
}

Scene everyKind() {
  TestRandom random(41);
  SceneBuilder b;
  for (int i = 0; i < 10; ++i) {
    double const s = random.between(0.05, 0.4);
    b.add(ShapeKind::box, randomPlace(random) * scaling({s, s / 2, -s / 3}));
    b.add(ShapeKind::sphere, randomPlace(random) * scaling({s, 0.3 * s, 0.5 * s}));
    b.add(ShapeKind::quad, randomPlace(random) * scaling({3 * s, s, s}));
    b.mesh(bumpyBall(10, 9), randomPlace(random) * scaling({s / 2, s, s / 3}));
  }
  return b.scene;
}

bool equal(const Bounds& a, const Bounds& b, double tolerance) {
  return glm::length(a.min - b.min) <= tolerance && glm::length(a.max - b.max) <= tolerance;
}

}  // namespace

TEST_CASE("spheres are picked at their near side, from within at the far one") {
  Scene const scene = one(ShapeKind::sphere, translation({1, 0, 0}) * scaling({2, 1, 1}));
  CHECK(hit(scene, {-5, 0, 0}, {1, 0, 0}) == doctest::Approx(4));
  CHECK(hit(scene, {1, 0, 0}, {1, 0, 0}) == doctest::Approx(2));
  CHECK(hit(scene, {1, 0, 0}, {0, 1, 0}) == doctest::Approx(1));
  CHECK(hit(scene, {4, 0, 0}, {1, 0, 0}) == -1);
  CHECK(hit(scene, {-5, 1.001, 0}, {1, 0, 0}) == -1);
}

TEST_CASE("boxes are picked, also along their axes") {
  Scene const scene = one(ShapeKind::box, scaling({1, 2, 3}));
  CHECK(hit(scene, {0, 0, 9}, {0, 0, -1}) == doctest::Approx(6));
  CHECK(hit(scene, {0, 0, 0}, {0, 1, 0}) == doctest::Approx(2));
  CHECK(hit(scene, {1, 2, 9}, {0, 0, -1}) == doctest::Approx(6));  // along an edge
  CHECK(hit(scene, {1.01, 0, 9}, {0, 0, -1}) == -1);
  CHECK(hit(scene, {0, 0, 9}, {0, 0, 1}) == -1);
  CHECK(hit(scene, {-2, 0, 0}, {1, 1, 0}) == doctest::Approx(std::sqrt(2.0)));
}

TEST_CASE("quads are picked from both sides and not from their plane") {
  Scene const scene = one(ShapeKind::quad, translation({0, 0, 2}));
  CHECK(hit(scene, {0.5, 0.5, 0}, {0, 0, 1}) == doctest::Approx(2));
  CHECK(hit(scene, {0.5, 0.5, 5}, {0, 0, -1}) == doctest::Approx(3));
  CHECK(hit(scene, {1.01, 0.5, 0}, {0, 0, 1}) == -1);
  CHECK(hit(scene, {0.5, -0.01, 0}, {0, 0, 1}) == -1);
  CHECK(hit(scene, {-1, 0.5, 2}, {1, 0, 0}) == -1);
}

TEST_CASE("the nearest shape is picked, the first of equal ones") {
  SceneBuilder b;
  b.add(ShapeKind::sphere, translation({0, 0, -5}));
  b.add(ShapeKind::sphere, Mat4d(1));
  b.add(ShapeKind::sphere, Mat4d(1));
  auto const found = pick(b.scene, {0, 0, 5}, {0, 0, -1});
  REQUIRE(found);
  CHECK(found->shape == 1);
  CHECK(found->point == Vec3d(0, 0, 1));
  CHECK_FALSE(pick(Scene{}, {0, 0, 5}, {0, 0, -1}));
}

TEST_CASE("rays of nothing and of nowhere pick nothing") {
  Scene const scene = everyKind();
  CHECK_FALSE(pick(scene, {0, 0, 5}, {0, 0, 0}));
  CHECK_FALSE(pick(scene, {0, 0, 0}, {0, 0, 0}));
  CHECK_FALSE(pick(scene, {NAN, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(pick(scene, {0, 0, 5}, {0, NAN, -1}));
}

TEST_CASE("scenes of any size are picked alike") {
  for (double size : {1e-13, 1e-9, 1e12}) {
    CAPTURE(size);
    for (ShapeKind kind : {ShapeKind::sphere, ShapeKind::box}) {
      Scene const scene = one(kind, scaling(Vec3d(size)));
      CHECK(hit(scene, Vec3d(0, 0, 5) * size, {0, 0, -1}) == doctest::Approx(4 * size).epsilon(1e-12));
    }
    Scene const mesh = SceneBuilder().mesh({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}, scaling(Vec3d(size))).scene;
    CHECK(hit(mesh, Vec3d(0.1, 0.1, 5) * size, {0, 0, -1}) == doctest::Approx(5 * size).epsilon(1e-12));
  }
}

TEST_CASE("no ray slips between the triangles of a closed mesh") {
  std::vector<FlatTriangle> const ball = bumpyBall(24, 25);
  Scene const scene = SceneBuilder().mesh(ball).scene;
  int escaped = 0;
  for (const FlatTriangle& t : ball)
    for (Vec3d at : {t.a, (t.a + t.b) / 2.0, (t.b + t.c) / 2.0, (t.c + t.a) / 2.0})
      escaped += !pick(scene, Vec3d(0), glm::normalize(at));
  CHECK(escaped == 0);
}

TEST_CASE("picks agree with the renderer's closest hits") {
  Scene const scene = everyKind();
  HostScene const host(flatten(scene));
  std::vector<int> const owner = shapeOfPrimitive(scene);
  REQUIRE(owner.size() == host.flat().primitiveCount());
  TestRandom random(42);
  int const rays = 4000;
  int hits = 0, otherwise = 0;
  for (int i = 0; i < rays; ++i) {
    cpu::Vec3 const origin(random.inBox(2)), direction = glm::normalize(cpu::Vec3(random.inBox(1)) - origin);
    Vec3d const unit = glm::normalize(Vec3d(direction));
    cpu::Ray const ray{origin, direction, cpu::infinity};
    cpu::Hit const expected = cpu::closestHitBruteForce<feature::all>(host.view(), ray);
    auto const found = pick(scene, Vec3d(origin), unit);
    hits += found.has_value();
    bool const agree = found.has_value() == expected.found() &&
                       (!found || (found->shape == owner[expected.primitive] &&
                                   std::abs(found->distance - double(expected.t)) <= 1e-4 * (1 + found->distance)));
    otherwise += !agree;
    if (found) CHECK(glm::length(found->point - (Vec3d(origin) + unit * found->distance)) < 1e-12);
  }
  CHECK(hits > rays / 4);
  CHECK(otherwise <= 2);  // silhouettes, which single precision sees elsewhere
}

TEST_CASE("bounds of shapes are exact") {
  Mat4d const place = translation({1, 2, 3}) * rotation({1, 1, 0}, 30) * scaling({1, 2, 3});
  Scene const scene = everyKind();
  CHECK(equal(sceneBounds(scene), flatten(scene).bounds, 1e-15));
  Bounds const box = shapeBounds(one(ShapeKind::box, scaling({1, 2, 3})), 0);
  CHECK(box.min == Vec3d(-1, -2, -3));
  CHECK(box.max == Vec3d(1, 2, 3));
  CHECK(equal(shapeBounds(one(ShapeKind::quad, translation({0, 0, 4})), 0), {{0, 0, 4}, {1, 1, 4}}, 0));
  TestRandom random(43);
  Bounds const ellipsoid = shapeBounds(one(ShapeKind::sphere, place), 0);
  Bounds sampled;
  for (int i = 0; i < 200000; ++i) sampled.grow(transformPoint(place, random.direction()));
  CHECK(equal(ellipsoid, sampled, 1e-3));
  for (int a = 0; a < 3; ++a) {
    CHECK(sampled.min[a] >= ellipsoid.min[a]);
    CHECK(sampled.max[a] <= ellipsoid.max[a]);
  }
}

TEST_CASE("bounds of no shape are empty, and unused vertices do not count") {
  Scene scene = SceneBuilder().mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}).scene;
  scene.meshes[0].positions.push_back({9, 9, 9});
  CHECK(sceneBounds(scene).max == Vec3d(1, 1, 0));
  CHECK(shapeBounds(scene, -1).empty());
  CHECK(shapeBounds(scene, 1).empty());
  CHECK(sceneBounds(Scene{}).empty());
}
