// Scenes far from the origin: they are rendered in a frame of their own.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "render/flatten/flatten.h"
#include "render/scene/transform.h"
#include "tests/scenes/coincident_scenes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

/// A room with a ball, a glass box, a mesh and a lamp, all with coordinates that are multiples of 2⁻⁶.
Scene room() {
  Scene scene = emptyScene(0.5f);
  int const glass = addMaterial(scene, DielectricParams{1.5f});
  addBox(scene, {-2, -1, -2}, {2, 3, 2});
  addQuad(scene, {-0.5, 2.875, -0.5}, {1, 0, 0}, {0, 0, 1}).emission = Emission{Rgb(8), Side::out};
  addSphere(scene, {-0.75, -0.25, 0}, 0.75);
  addBox(scene, {0.25, -0.875, -0.5}, {1, 0.5, 0.25}, glass);
  addMeshBox(scene, {-0.5, -0.75, 0.75}, {0.5, 0.25, 1.25}, 0);
  lookAt(scene, {1.5, 1.5, 1.75}, {0, 0, 0}, {0, 1, 0}, 60);
  return scene;
}

/// Everything moved: the mesh by its vertices, as files hold it, the others by their transforms.
Scene movedScene(Scene scene, Vec3d by) {
  scene.camera = moved(scene.camera, by);
  for (ShapeDesc& s : scene.shapes) {
    if (s.kind != ShapeKind::mesh) s.toWorld = translation(by) * s.toWorld;
    if (s.kind == ShapeKind::mesh)
      for (Vec3d& p : scene.meshes[std::size_t(s.mesh)].positions) p += by;
  }
  return scene;
}

Settings small(Mode mode, std::uint64_t seed = 1) {
  Settings s = settingsFor(mode, 48, 48);
  s.photons = 10000;
  s.seed = seed;
  return s;
}

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(a.pixels[0])) == 0;
}

}  // namespace

TEST_CASE("scenes around the origin stay where they are, distant ones come to it") {
  CHECK(flatten(room()).origin == Vec3d(0.0));
  for (double far : {1e4, 1e5, 1e6, 1e7}) {
    FlatScene const flat = flatten(movedScene(room(), Vec3d(far, -far, 0.3 * far)));
    CHECK(glm::length(flat.origin - Vec3d(far, -far, 0.3 * far)) < 32);
    CHECK(flat.reach < 32);
    Vec3d const steps = flat.origin / 16.0;
    CHECK(steps == glm::floor(steps));
  }
}

TEST_CASE("a move by powers of two changes no bit") {
  for (const BackendChoice& backend : everyBackend())
    for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm}) {
      Image const here = renderImage(room(), small(mode), 4, nullptr, backend);
      for (int power : {10, 14, 17, 20, 23}) {
        double const far = std::ldexp(1, power);
        CAPTURE(nameOf(mode));
        CAPTURE(power);
        CHECK(sameBits(here,
                       renderImage(movedScene(room(), Vec3d(far, -far, 2 * far)), small(mode), 4, nullptr, backend)));
      }
    }
}

TEST_CASE("offsets of 1e3 to 1e7 give the picture of the scene at the origin" * doctest::test_suite("slow")) {
  for (Mode const mode : {Mode::path, Mode::sppm}) {
    TileStatistics const here = tileStatistics(renderSeeds(room(), small(mode), 8, 8), 16);
    for (double far : {1e3, 1e4, 1e5, 1e6, 1e7}) {
      CAPTURE(far);
      CAPTURE(nameOf(mode));
      Scene const there = movedScene(room(), Vec3d(far / 3, far, -far / 7));
      CHECK(disagreement(tileStatistics(renderSeeds(there, small(mode), 8, 8), 16), here, 0.005) == "");
    }
  }
}

TEST_CASE("a furnace far from the origin is as bright as one near it" * doctest::test_suite("slow")) {
  for (double far : {0.0, 1e5, 1e6, 1e7}) {
    CAPTURE(far);
    Scene scene = emptyScene(0.5f);
    addBox(scene, {far - 1, -1, far - 1}, {far + 1, 1, far + 1}).emission = Emission{Rgb(1), Side::in};
    lookAt(scene, {far + 0.3, 0.1, far + 0.2}, {far - 1, -0.8, far - 0.9}, {0, 1, 0}, 70);
    for (DirectLight const direct : {DirectLight::shadow, DirectLight::photons}) {
      Settings settings = settingsFor(Mode::sppm, 32, 32);
      settings.photons = 30000;
      settings.direct = direct;
      CHECK(meanOf(renderImage(scene, settings, 32)) == doctest::Approx(2).epsilon(0.01));
    }
    CHECK(meanOf(renderImage(scene, settingsFor(Mode::path, 32, 32), 64)) == doctest::Approx(2).epsilon(0.01));
  }
}

TEST_CASE("placed meshes far from the origin are met where they are") {
  Scene scene = room();
  int const mesh = scene.shapes.back().mesh;
  for (int i = 0; i < 3; ++i) {
    ShapeDesc shape = scene.shapes.back();
    shape.mesh = mesh;
    shape.toWorld = translation({0.25 * i, 0.5 + 0.5 * i, -1}) * scaling(Vec3d(0.25));
    scene.shapes.push_back(shape);
  }
  Scene far = scene;
  Vec3d const by(std::ldexp(1, 20), 0, 0);
  far.camera = moved(far.camera, by);
  for (ShapeDesc& s : far.shapes) s.toWorld = translation(by) * s.toWorld;
  FlatScene const near = flatten(scene, Instancing::always), distant = flatten(far, Instancing::always);
  REQUIRE(near.instances.size() == distant.instances.size());
  for (std::size_t i = 0; i < near.instances.size(); ++i) {
    CHECK(near.instances[i].toWorld == distant.instances[i].toWorld);
    CHECK(near.instances[i].bounds.min == distant.instances[i].bounds.min);
  }
}
