// Renderings against closed forms.

#include <doctest/doctest.h>

#include <cmath>

#include "render/kernels/commit.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

/// A camera just above a patch of floor (y = 0) around (x, 0): every pixel sees nearly the same irradiance.
void lookAtFloor(Scene& scene, double x) { lookAt(scene, {x, 0.01, 0}, {x, 0, 0}, {0, 0, 1}, 10); }

void addFloor(Scene& scene) { addQuad(scene, {-20, 0, -20}, {0, 0, 40}, {40, 0, 0}); }

/// Irradiance below the corner of a parallel rectangle a × b at height h, over π L (Howell's configuration C-11).
double cornerFactor(double a, double b, double h) {
  double const x = a / h, y = b / h, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * M_PI);
}

/// The same below any point, for the rectangle [x0, x1] × [z0, z1].
double rectangleFactor(double x0, double x1, double z0, double z1, double h) {
  auto const signedCorner = [&](double x, double z) {
    return std::copysign(1.0, x * z) * cornerFactor(std::abs(x), std::abs(z), h);
  };
  return signedCorner(x1, z1) - signedCorner(x0, z1) - signedCorner(x1, z0) + signedCorner(x0, z0);
}

Scene furnace(float albedo) {
  Scene scene = emptyScene(albedo);
  addSphere(scene, {0, 0, 0}, 1).emission = Emission{Rgb(1), Side::in};
  lookAt(scene, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60);
  return scene;
}

}  // namespace

TEST_CASE("a closed furnace shows 1/(1 - albedo) in path and sppm" * doctest::test_suite("slow")) {
  for (float albedo : {0.2f, 0.5f, 0.8f}) {
    CAPTURE(albedo);
    double const expected = 1 / (1 - double(albedo));
    Image const path = renderImage(furnace(albedo), settingsFor(Mode::path, 32, 32), 128);
    CHECK(meanOf(path) == doctest::Approx(expected).epsilon(0.005));
    Settings settings = settingsFor(Mode::sppm, 32, 32);
    settings.photons = 65536;
    settings.radius = 0.05;
    Image const sppm = renderImage(furnace(albedo), settings, 16);
    CHECK(meanOf(sppm) == doctest::Approx(expected).epsilon(0.005));
  }
}

TEST_CASE("a furnace of an ellipsoid is as bright") {
  Scene scene = furnace(0.5f);
  scene.shapes[0].toWorld[0] *= 2.0;
  scene.shapes[0].toWorld[1] *= 0.7;
  CHECK(meanOf(renderImage(scene, settingsFor(Mode::path, 32, 32), 256)) == doctest::Approx(2).epsilon(0.01));
  Settings settings = settingsFor(Mode::sppm, 32, 32);
  settings.photons = 65536;
  settings.radius = 0.03;
  CHECK(meanOf(renderImage(scene, settings, 16)) == doctest::Approx(2).epsilon(0.01));
}

TEST_CASE("irradiance under a sphere light is pi L (R/d)^2 cos") {
  for (double x : {0.0, 1.0, 3.0}) {
    CAPTURE(x);
    Scene scene = emptyScene(1);
    addFloor(scene);
    addSphere(scene, {0, 2, 0}, 0.5).emission = Emission{Rgb(3), Side::out};
    lookAtFloor(scene, x);
    double const d = std::hypot(x, 2.0);
    double const radiance = 3 * (0.5 / d) * (0.5 / d) * (2 / d);  // E/π for albedo 1
    for (Mode const mode : {Mode::ray, Mode::path}) {
      Settings settings = settingsFor(mode, 16, 16);
      settings.maxDepth = 2;
      CHECK(meanOf(renderImage(scene, settings, 256)) == doctest::Approx(radiance).epsilon(0.003));
    }
  }
}

TEST_CASE("irradiance under a quad light has the closed form") {
  for (double x : {0.0, 0.8, 3.0}) {
    CAPTURE(x);
    Scene scene = emptyScene(1);
    addFloor(scene);
    addQuad(scene, {-0.6, 1.5, -0.4}, {1.2, 0, 0}, {0, 0, 0.8}).emission = Emission{Rgb(2), Side::out};
    lookAtFloor(scene, x);
    double const radiance = 2 * rectangleFactor(-0.6 - x, 0.6 - x, -0.4, 0.4, 1.5);
    for (Mode const mode : {Mode::ray, Mode::path}) {
      Settings settings = settingsFor(mode, 16, 16);
      settings.maxDepth = 2;
      CHECK(meanOf(renderImage(scene, settings, 256)) == doctest::Approx(radiance).epsilon(0.003));
    }
  }
}

TEST_CASE("photons carry the direct light of shadow rays" * doctest::test_suite("slow")) {
  Scene scene = emptyScene(0.7f);
  addFloor(scene);
  addQuad(scene, {-0.6, 1.5, -0.4}, {1.2, 0, 0}, {0, 0, 0.8}).emission = Emission{Rgb(2), Side::out};
  addSphere(scene, {1, 3, 0}, 0.4).emission = Emission{Rgb(1, 5, 2), Side::out};
  lookAt(scene, {0.3, 1, 0}, {0.3, 0, 0}, {0, 0, 1}, 40);
  Settings shadow = settingsFor(Mode::ray, 32, 32);
  shadow.maxDepth = 2;
  Settings photons = shadow;
  photons.mode = Mode::sppm;
  photons.direct = DirectLight::photons;
  photons.photons = 262144;
  photons.radius = 0.1;
  double const expected = meanOf(renderImage(scene, shadow, 128));
  CHECK(meanOf(renderImage(scene, photons, 24)) == doctest::Approx(expected).epsilon(0.005));
}

TEST_CASE("the caustic of a plane mirror is the light of its image source" * doctest::test_suite("slow")) {
  // A vertical mirror at x = 1; the light near it faces down. The image of the light stands at 2 − x.
  Scene scene = emptyScene(1);
  addFloor(scene);
  int const mirror = addMaterial(scene, MirrorParams{});
  addQuad(scene, {1, 0, -20}, {0, 20, 0}, {0, 0, 40}, mirror);
  addQuad(scene, {0.2, 1, -0.2}, {0.4, 0, 0}, {0, 0, 0.4}).emission = Emission{Rgb(4), Side::out};
  double const x = 0.3;
  lookAtFloor(scene, x);
  Settings settings = settingsFor(Mode::sppm, 16, 16);
  settings.maxDepth = 3;  // camera, mirror, light
  settings.indirectOnly = true;
  settings.photons = 262144;
  settings.radius = 0.03;
  double const radiance = 4 * rectangleFactor(1.4 - x, 1.8 - x, -0.2, 0.2, 1);
  CHECK(meanOf(renderImage(scene, settings, 512)) == doctest::Approx(radiance).epsilon(0.01));
}

TEST_CASE("the film's mean does not stall") {
  // Film sums are doubles: 2^25 samples of 0.1 in float would stop growing near 2^21.
  glm::dvec3 sum(0.0);
  Rgb const sample(0.1f, 1.0f, 1000.0f);
  cpu::IterationState state;
  ropelight::Tally tally;
  std::uint32_t missing = 0;
  cpu::CommitFilm const commit{{&sample, 1}, {&sum, 1}, {&missing, 1}, {&state, 1}};
  std::uint32_t const count = 1u << 25;
  for (std::uint32_t i = 0; i < count; ++i) commit(0, tally);
  CHECK(sum.x / count == doctest::Approx(double(0.1f)).epsilon(1e-7));
  CHECK(sum.z / count == doctest::Approx(1000.0).epsilon(1e-7));
}

TEST_CASE("a sample that is not finite is missing, not black") {
  glm::dvec3 sum(0.0);
  Rgb sample(2.0f);
  std::uint32_t missing = 0;
  cpu::IterationState state;
  ropelight::Tally tally;
  cpu::CommitFilm const commit{{&sample, 1}, {&sum, 1}, {&missing, 1}, {&state, 1}};
  for (float value : {2.0f, NAN, 4.0f, INFINITY, -INFINITY}) {
    sample.y = value;
    commit(0, tally);
  }
  CHECK(tally.nonFinite == 3);
  CHECK(cpu::meanOf(sum, 5, missing).y == 3.0f);
  CHECK(cpu::meanOf(sum, 5, missing).x == 2.0f);
  CHECK(cpu::meanOf(glm::dvec3(0.0), 3, 3) == Rgb(0.0f));
}
