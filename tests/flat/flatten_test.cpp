// Scenes as flat primitives: orientation, areas, bounds, lights and features.

#include "render/flatten/flatten.h"
#include "render/prepare/prepare.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "render/core/error.h"
#include "render/prepare/structure_choice.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

Vec3d normalOf(const FlatQuad& q) {
  return glm::normalize(glm::cross(q.corner[1] - q.corner[0], q.corner[3] - q.corner[0]));
}

/// Turned, sheared, mirrored and displaced transforms.
std::vector<Mat4d> transforms() {
  Mat4d shear(1.0);
  shear[1][0] = 0.7;
  Mat4d const place = translation({3, -7, 2}) * rotation({1, 2, 3}, 70);
  return {Mat4d(1.0),
          place,
          place * scaling({2, 0.1, 5}),
          place * shear,
          scaling({-1, 1, 1}),
          place * scaling({1, 1, -1}),
          place * shear * scaling({-2, -3, -0.5})};
}

/// A place of the file in the scene's frame.
Mat4d inFrame(const FlatScene& flat, const Mat4d& m) { return translation(-flat.origin) * m; }

FlatScene flatOf(ShapeKind kind, const Mat4d& toWorld) { return flatten(SceneBuilder().add(kind, toWorld).scene); }

/// ∫ |det M| |M⁻ᵀ n| dω by midpoints in (z, φ), on an axis along the needle or across the disc.
double areaByQuadrature(const Mat3d& m) {
  constexpr int steps = 1000;
  Mat3d const cofactor = glm::transpose(glm::inverse(m)) * std::abs(glm::determinant(m));
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      double const z = 2 * (i + 0.5) / steps - 1, phi = 2 * M_PI * (j + 0.5) / steps, r = std::sqrt(1 - z * z);
      sum += glm::length(cofactor * Vec3d(r * std::cos(phi), r * std::sin(phi), z));
    }
  return sum * 4 * M_PI / (steps * steps);
}

/// A tetrahedron around the origin, counter-clockwise seen from outside.
std::vector<FlatTriangle> tetrahedron() {
  Vec3d const a(1, 1, 1), b(-1, -1, 1), c(-1, 1, -1), d(1, -1, -1);
  return {{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}};
}

}  // namespace

TEST_CASE("the faces of a box look outward, whatever its transform") {
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatOf(ShapeKind::box, m);
    REQUIRE(flat.quads.size() == 6);
    Vec3d const center(inFrame(flat, m)[3]);
    for (const FlatQuad& q : flat.quads) {
      CHECK(glm::dot(normalOf(q), 0.5 * (q.corner[0] + q.corner[2]) - center) > 0);
      CHECK(glm::length(q.corner[0] + q.corner[2] - q.corner[1] - q.corner[3]) < 1e-14 * flat.reach);
    }
  }
}

TEST_CASE("neighbouring faces of a box share their edges bit for bit, in opposite directions") {
  for (const Mat4d& m : transforms()) {
    std::map<std::tuple<double, double, double, double, double, double>, int> edges;
    FlatScene const flat = flatOf(ShapeKind::box, m);
    for (const FlatQuad& q : flat.quads)
      for (int k = 0; k < 4; ++k) {
        Vec3d const a = q.corner[k], b = q.corner[(k + 1) % 4];
        ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
      }
    CHECK(edges.size() == 24);
    for (const auto& [e, count] : edges) {
      auto const [ax, ay, az, bx, by, bz] = e;
      CHECK(edges.count({bx, by, bz, ax, ay, az}) == 1);
    }
  }
}

TEST_CASE("a quad's normal follows its +z through mirroring transforms") {
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatOf(ShapeKind::quad, m);
    Vec3d const expected = glm::normalize(glm::transpose(glm::inverse(Mat3d(m))) * Vec3d(0, 0, 1));
    CHECK(glm::length(normalOf(flat.quads[0]) - expected) < 1e-12);
    Mat4d const here = inFrame(flat, m);
    CHECK(glm::length(flat.quads[0].corner[0] - transformPoint(here, {0, 0, 0})) < 1e-14);
    CHECK(glm::length(flat.quads[0].corner[2] - transformPoint(here, {1, 1, 0})) < 1e-14);
  }
}

TEST_CASE("the triangles of a mesh look outward through mirroring transforms") {
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatten(SceneBuilder().mesh(tetrahedron(), m).scene);
    REQUIRE(flat.triangles.size() == 4);
    for (const FlatTriangle& t : flat.triangles)
      CHECK(glm::dot(glm::cross(t.b - t.a, t.c - t.a), t.a - Vec3d(inFrame(flat, m)[3])) > 0);
  }
}

TEST_CASE("a mirrored sphere keeps its surface and its outside") {
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatOf(ShapeKind::sphere, m);
    const FlatSphere& s = flat.spheres.at(0);
    CHECK(glm::determinant(s.toWorld) > 0);
    Mat3d const a = s.toWorld * glm::transpose(s.toWorld), b = Mat3d(m) * glm::transpose(Mat3d(m));
    for (int c = 0; c < 3; ++c) CHECK(glm::length(a[c] - b[c]) < 1e-12);
    CHECK(s.center == Vec3d(m[3]) - flat.origin);
  }
}

TEST_CASE("singular values are those of the map, turned or not, large or small") {
  TestRandom random(1);
  for (int i = 0; i < 100; ++i) {
    double const a = std::pow(10, random.between(-4, 4)), b = a * random.unit(), c = b * random.unit();
    Mat3d const u(rotation(random.direction(), random.between(0, 360)));
    Mat3d const v(rotation(random.direction(), random.between(0, 360)));
    Vec3d const s = singularValues(u * Mat3d(scaling({b, -c, a})) * v);
    CHECK(std::abs(s.x - a) < 1e-13 * a);
    CHECK(std::abs(s.y - b) < 1e-13 * a);
    CHECK(std::abs(s.z - c) < 1e-13 * a);
  }
  Mat3d shear(1.0);
  shear[1][0] = 1;
  CHECK(singularValues(shear).x == doctest::Approx((1 + std::sqrt(5)) / 2).epsilon(1e-14));  // the golden ratio
  CHECK(singularValues(Mat3d(0.0)) == Vec3d(0.0));
}

TEST_CASE("the area of an ellipsoid is its quadrature") {
  Mat3d const u(rotation({1, 2, 3}, 40)), v(rotation({-2, 1, 0.5}, 110));
  for (Vec3d axes : {Vec3d(1, 1, 1), Vec3d(2, 2, 0.5), Vec3d(0.5, 0.5, 3), Vec3d(1, 2, 3), Vec3d(1, 1, 1e-3),
                     Vec3d(1e-3, 2e-3, 1), Vec3d(1, 1e-3, 0.5)}) {
    Mat3d const m(scaling(axes));
    double const expected = areaByQuadrature(m);
    CAPTURE(axes.z);
    for (double scale : {1.0, 1e-12, 1e12})
      for (const Mat3d& map : {m, u * m * v})
        CHECK(ellipsoidArea(scale * map) / (scale * scale * expected) == doctest::Approx(1).epsilon(3e-5));
  }
}

TEST_CASE("the area of a sphere, a disc and a needle is the closed form") {
  Mat3d const u(rotation({1, 2, 3}, 40)), v(rotation({-2, 1, 0.5}, 110));
  CHECK(ellipsoidArea(Mat3d(3.0)) == doctest::Approx(36 * M_PI).epsilon(1e-14));
  for (double thin : {1e-5, 1e-7}) {
    CHECK(ellipsoidArea(u * Mat3d(scaling({1, 2, thin})) * v) == doctest::Approx(4 * M_PI).epsilon(1e-6));
    double const needle = ellipsoidArea(u * Mat3d(scaling({1, thin, thin})) * v);
    CHECK(needle / (M_PI * M_PI * thin) == doctest::Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("primitive bounds hold the primitive and no more") {
  TestRandom random(2);
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatOf(ShapeKind::sphere, m);
    Bounds const b = flat.primitiveBounds(0);
    Bounds seen;
    for (int i = 0; i < 20000; ++i) seen.grow(transformPoint(inFrame(flat, m), random.direction()));
    for (int a = 0; a < 3; ++a) {
      CHECK((seen.min[a] >= b.min[a] - 1e-12 && seen.max[a] <= b.max[a] + 1e-12));
      CHECK(seen.extent()[a] > 0.99 * b.extent()[a]);
    }
  }
  FlatScene const flat = flatten(SceneBuilder().mesh(tetrahedron()).add(ShapeKind::quad, Mat4d(1.0)).scene);
  CHECK(flat.primitiveBounds(0).max == Vec3d(1, 1, 0));
  CHECK(flat.primitiveBounds(1).min == Vec3d(-1, -1, -1));
  CHECK(flat.bounds.extent() == Vec3d(2));
}

TEST_CASE("reach spans the scene, the camera and the origin") {
  SceneBuilder b;
  b.add(ShapeKind::sphere, translation({10, 0, 0})).cameraAt({0, -30, 0});
  CHECK(flatten(b.scene).reach == doctest::Approx(31));
  b.cameraAt({0, 0, 0});
  CHECK(flatten(b.scene).reach == doctest::Approx(11));
  b.add(ShapeKind::sphere, translation({1e15, 0, 0}));
  CHECK_THROWS_AS(flatten(b.scene), Error);
}

TEST_CASE("a surface is never said to miss a box that holds a point of it") {
  TestRandom random(3);
  for (const Mat4d& m : transforms()) {
    FlatScene const flat = flatOf(ShapeKind::sphere, m);
    int missed = 0;
    for (int i = 0; i < 5000; ++i) {
      Vec3d const p = transformPoint(inFrame(flat, m), random.direction());
      Vec3d const low(random.unit(), random.unit(), random.unit()), high(random.unit(), random.unit(), random.unit());
      double const size = std::pow(10, random.between(-6, 1));
      missed += !flat.overlapsSurface(0, Bounds{p - size * low, p + size * high});
    }
    CHECK(missed == 0);
    Vec3d const center(inFrame(flat, m)[3]);
    CHECK_FALSE(flat.overlapsSurface(0, Bounds{center - 0.01, center + 0.01}));
    CHECK_FALSE(flat.overlapsSurface(0, Bounds{Vec3d(100), Vec3d(101)}));
  }
}

TEST_CASE("primitives are numbered quads first, then spheres, then triangles") {
  SceneBuilder b;
  b.scene.materials.push_back({"mirror", MirrorParams{}});
  b.mesh(tetrahedron()).add(ShapeKind::sphere, scaling({2, 2, 2})).add(ShapeKind::box, Mat4d(1.0));
  b.add(ShapeKind::quad, scaling({3, 1, 1}), Emission{Rgb(1.0f)});
  b.scene.shapes[2].material = 1;  // the box
  FlatScene const flat = flatten(b.scene);
  CHECK(flat.primitiveCount() == 12);
  CHECK((flat.quads.size() == 7 && flat.spheres.size() == 1 && flat.triangles.size() == 4));
  CHECK(flat.material == std::vector<std::uint32_t>{1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0});
  CHECK(flat.lights.at(0).primitive == 6);
  CHECK(flat.light.at(6) == 0);
  CHECK(flat.light.at(7) == -1);
  double const triangles = 4 * std::sqrt(3) / 4 * 8;  // edges of √8
  CHECK(flat.diffuseArea == doctest::Approx(3 + 16 * M_PI + triangles));
}

TEST_CASE("a light's power is pi times radiance and area, on each side that emits") {
  SceneBuilder b;
  b.add(ShapeKind::quad, scaling({2, 3, 1}), Emission{Rgb(1, 2, 6), Side::out});
  b.add(ShapeKind::sphere, scaling({2, 2, 2}), Emission{Rgb(1.0f), Side::both});
  b.add(ShapeKind::box, Mat4d(1.0), Emission{Rgb(0.5f), Side::in});
  b.add(ShapeKind::quad, Mat4d(1.0), Emission{Rgb(0.0f), Side::out});
  FlatScene const flat = flatten(b.scene);
  REQUIRE(flat.lights.size() == 8);  // a black emitter is none
  std::map<Side, double> power;
  for (const FlatLight& l : flat.lights) power[l.side] += l.power;
  CHECK(power[Side::out] == doctest::Approx(M_PI * 3 * 6));
  CHECK(power[Side::in] == doctest::Approx(M_PI * 0.5 * 24));
  CHECK(power[Side::both] == doctest::Approx(M_PI * 16 * M_PI * 2));
}

TEST_CASE("features say what a scene needs and nothing else") {
  auto const features = [](const SceneBuilder& b) { return featuresOf(flatten(b.scene), b.scene.camera); };
  SceneBuilder b;
  CHECK(features(b) == 0);
  b.add(ShapeKind::sphere, Mat4d(1.0));
  CHECK(features(b) == (feature::spheres | feature::diffuse));
  b.scene.materials[0].desc = MirrorParams{};
  CHECK(features(b) == (feature::spheres | feature::mirror));
  b.scene.materials.push_back({"glass, unused", DielectricParams{}});
  CHECK(features(b) == (feature::spheres | feature::mirror));
  b.add(ShapeKind::box, Mat4d(1.0), Emission{});
  b.scene.shapes.back().material = 1;
  CHECK(features(b) == (feature::quads | feature::spheres | feature::mirror | feature::dielectric | feature::lights));
  b.mesh(tetrahedron());
  b.scene.camera.apertureRadius = 0.1;
  CHECK((features(b) & (feature::triangles | feature::lens)) == (feature::triangles | feature::lens));
}

TEST_CASE("settings add a tree, photons and the k-nearest gather only where there is use for them") {
  SceneBuilder b;
  b.add(ShapeKind::sphere, Mat4d(1.0));
  Settings s;
  auto const has = [&](FeatureBits bit) { return (featuresOf(flatten(b.scene), b.scene.camera, s) & bit) != 0; };
  s.gather = GatherBy::nearest;
  CHECK_FALSE(has(feature::tree | feature::photons | feature::nearest));  // no light, one primitive
  s.accel = Accel::tree;
  CHECK(has(feature::tree));
  s.accel = Accel::automatic;
  b.add(ShapeKind::quad, Mat4d(1.0), Emission{});
  CHECK(has(feature::photons));
  CHECK(has(feature::nearest));
  s.mode = Mode::path;
  CHECK_FALSE(has(feature::photons | feature::nearest));
  s.mode = Mode::sppm;
  b.scene.materials[0].desc = MirrorParams{};
  CHECK_FALSE(has(feature::photons));
  for (std::uint32_t i = 0; i < bruteForceLimit; ++i) b.add(ShapeKind::sphere, Mat4d(1.0));
  CHECK(has(feature::bvh));
  s.accel = Accel::shortStack;
  CHECK(has(feature::tree));
  CHECK(has(feature::shortStack));
  s.accel = Accel::tree;
  CHECK(has(feature::tree));
  CHECK_FALSE(has(feature::bvh | feature::shortStack));
  s.accel = Accel::brute;
  CHECK_FALSE(has(feature::tree | feature::bvh));
}
