// Lights of 10⁻⁷ to 10⁶ of their distance against closed forms: direct light of every shape, by every mode.

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "tests/oracle/oracle.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

/// Irradiance over πL below the middle of a parallel square of this edge at distance 1 (Howell's configuration C-11).
double squareFactor(double edge) {
  double const x = edge / 2, p = std::sqrt(1 + x * x);
  return 4 * (2 * x / p * std::atan(x / p)) / (2 * M_PI);
}

double sphereFactor(double radius, double height) { return (radius / height) * (radius / height); }

/// Below an ellipsoid of half-axes (a, b, a) whose middle is at this height: ∫ cos θ dω / π over the cone that it
/// fills. Scaled by 1/b along y the cone's rim is that of a sphere: with D = height/b its slope is s = a/(b √(D² − 1)),
/// and the light of a circular cone is sin² of its half-angle.
double spheroidFactor(double a, double b, double height) {
  double const d = height / b, slope = a / b / std::sqrt((d - 1) * (d + 1));
  return slope * slope / (1 + slope * slope);
}

/// A white floor seen from just above the origin, under a black shape of radiance such that 0.25 is seen.
Scene under(double factor, const std::function<ShapeDesc&(Scene&, int material)>& add) {
  Scene scene = emptyScene(1);
  addQuad(scene, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  int const black = addMaterial(scene, DiffuseParams{Rgb(0.0f)});
  add(scene, black).emission = Emission{Rgb(float(0.25 / factor)), Side::out};
  lookAt(scene, {0, 0.001, 0}, {0, 0, 0}, {0, 0, 1}, 10);
  return scene;
}

struct Lamp {
  const char* shape;
  double factor;
  std::function<ShapeDesc&(Scene&, int)> add;
};

/// Of this size over its distance, which is 1 from the nearest point of large ones and from the middle of small ones.
std::vector<Lamp> lamps(double size) {
  double const middle = size < 1 ? 1 : 1 + size, flat = size < 1 ? 1 : 1 + 0.5 * size;
  auto const sphere = [=](Scene& s, int m) -> ShapeDesc& { return addSphere(s, {0, middle, 0}, size, m); };
  auto const spheroid = [=](Scene& s, int m) -> ShapeDesc& {
    ShapeDesc& shape = addSphere(s, {0, flat, 0}, size, m);
    shape.toWorld[1] *= 0.5;
    return shape;
  };
  auto const quad = [=](Scene& s, int m) -> ShapeDesc& {
    return addQuad(s, {-size / 2, 1, -size / 2}, {size, 0, 0}, {0, 0, size}, m);
  };
  auto const box = [=](Scene& s, int m) -> ShapeDesc& {
    return addBox(s, {-size / 2, 1, -size / 2}, {size / 2, 1 + size, size / 2}, m);
  };
  return {{"sphere", sphereFactor(size, middle), sphere},
          {"ellipsoid", spheroidFactor(size, size / 2, flat), spheroid},
          {"quad", squareFactor(size), quad},
          {"box", squareFactor(size), box}};
}

double seen(const Lamp& lamp, Mode mode, int iterations, const BackendChoice& backend) {
  Settings settings = settingsFor(mode, 16, 16);
  settings.photons = 1024;
  settings.maxDepth = 2;
  return meanOf(renderImage(under(lamp.factor, lamp.add), settings, iterations, nullptr, backend));
}

}  // namespace

TEST_CASE("lights of 1e-7 to 1e6 of their distance keep their irradiance within half a percent" *
          doctest::test_suite("slow")) {
  for (const BackendChoice& backend : everyBackend())
    for (int decade = -7; decade <= 6; ++decade)
      for (const Lamp& lamp : lamps(std::pow(10.0, decade)))
        for (Mode const mode : {Mode::path, Mode::sppm, Mode::ray}) {
          CAPTURE(nameOf(backend.backend));
          CAPTURE(decade);
          CAPTURE(lamp.shape);
          CAPTURE(nameOf(mode));
          CHECK(seen(lamp, mode, 256, backend) == doctest::Approx(0.25).epsilon(0.005));
        }
}

TEST_CASE("the double-precision oracle agrees about lamps that are small or large against their distance") {
  for (double size : {1e-3, 0.1, 1.0}) {
    CAPTURE(size);
    Lamp const lamp = lamps(size)[0];
    double const height = size < 1 ? 1 : 1 + size;
    oracle::Scene scene{{{0, 0.001, 0}, {0, 0, 0}, {0, 0, 1}, 10, 2, 2},
                        {{oracle::Parallelogram{{-50, 0, 50}, {100, 0, 0}, {0, 0, -100}}, oracle::Diffuse{{1, 1, 1}}},
                         {oracle::Sphere{{0, height, 0}, size}, oracle::Diffuse{}, {{1, 1, 1}}}}};
    double const radiance = 0.25 / lamp.factor;
    scene.shapes[1].emission.radiance = {radiance, radiance, radiance};
    std::vector<double> variance;
    auto const image = oracle::render(scene, 20000, 3, 2, {}, &variance);
    auto const tile = oracle::tileMeans(image, variance, 2, 2).front();
    double const sigma = std::sqrt(tile.variance);
    CHECK(sigma < 0.002);
    CHECK(std::abs(tile.mean[0] - 0.25) < 4 * sigma);
    CHECK(std::abs(seen(lamp, Mode::path, 256, {BackendKind::cpu, 0, 0, false}) - tile.mean[0]) < 4 * sigma + 0.001);
  }
}

TEST_CASE("a huge light that emits on both sides or inwards is seen from where it shines") {
  for (Side side : {Side::out, Side::in, Side::both}) {
    Scene scene = emptyScene(1);
    addQuad(scene, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    int const black = addMaterial(scene, DiffuseParams{Rgb(0.0f)});
    addSphere(scene, {0, 1e4 + 1, 0}, 1e4, black).emission = Emission{Rgb(1), side};
    lookAt(scene, {0, 0.001, 0}, {0, 0, 0}, {0, 0, 1}, 10);
    for (Mode const mode : {Mode::path, Mode::sppm}) {
      Settings settings = settingsFor(mode, 16, 16);
      settings.photons = 1024;
      settings.maxDepth = 2;
      CAPTURE(int(side));
      CAPTURE(nameOf(mode));
      CHECK(meanOf(renderImage(scene, settings, 64)) == doctest::Approx(side == Side::in ? 0.0 : 1.0).epsilon(0.005));
    }
  }
}

TEST_CASE("a wall that a large light touches is lit as the closed form says") {
  // A vertical element at the height h below a ceiling of width b that starts at the wall and is very long: by the
  // crossed-strings method F = (1 − h/√(h² + b²))/2.
  Scene scene = emptyScene(1);
  addQuad(scene, {0, -50, -50}, {0, 100, 0}, {0, 0, 100});
  int const black = addMaterial(scene, DiffuseParams{Rgb(0.0f)});
  double const b = 2;
  addQuad(scene, {0, 0, -5000}, {b, 0, 0}, {0, 0, 10000}, black).emission = Emission{Rgb(1), Side::both};
  for (double h : {1.0, 0.1, 0.01}) {
    lookAt(scene, {0.001 * h, -h, 0}, {0, -h, 0}, {0, 1, 0}, 10);
    double const expected = (1 - h / std::hypot(h, b)) / 2;
    for (Mode const mode : {Mode::path, Mode::sppm}) {
      Settings settings = settingsFor(mode, 16, 16);
      settings.photons = 1024;
      settings.maxDepth = 2;
      CAPTURE(h);
      CAPTURE(nameOf(mode));
      CHECK(meanOf(renderImage(scene, settings, 512)) == doctest::Approx(expected).epsilon(0.01));
    }
  }
}
