// Which light a photon or a shadow ray takes, and what it carries.

#include <doctest/doctest.h>

#include "render/flatten/flatten.h"
#include "render/light/lights.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/chi_square.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr FeatureBits F = feature::all;

/// A dim quad, a bright sphere, a flat ellipsoid that emits on both sides, a box that emits inwards.
FlatScene fourLights() {
  SceneBuilder b;
  b.add(ShapeKind::quad, translation({5, 0, 0}), Emission{Rgb(1, 0, 0), Side::out});
  b.add(ShapeKind::sphere, translation({-5, 0, 0}) * scaling({0.5, 0.5, 0.5}), Emission{Rgb(2, 4, 6), Side::out});
  b.add(ShapeKind::sphere, translation({0, 5, 0}) * scaling({1, 1, 0.1}), Emission{Rgb(0, 0.5f, 0), Side::both});
  b.add(ShapeKind::box, translation({0, -5, 0}), Emission{Rgb(0.1f), Side::in});
  b.add(ShapeKind::quad, translation({0, 0, 5}));
  return flatten(b.scene);
}

}  // namespace

TEST_CASE("photons start on lights in proportion to power, each with the same flux before colour") {
  HostScene const scene(fourLights());
  const FlatScene& flat = scene.flat();
  REQUIRE(flat.lights.size() == 9);
  constexpr int n = 100000;
  double total = 0;
  for (const FlatLight& l : flat.lights) total += l.power;
  std::vector<std::uint64_t> observed(flat.lights.size(), 0);
  std::vector<double> expected;
  TestRandom random(1);
  glm::dvec3 flux(0.0);
  double worst = 0;
  int wrongSide = 0, bothOut = 0, both = 0;
  for (int i = 0; i < n; ++i) {
    Vec2 const u = random.vec2();
    Emitted const e = emitPhoton<F>(scene.view(), u.x, random.vec2(), random.vec2(), Real(n));
    std::size_t const light = std::size_t(flat.light[e.surface.primitive]);
    ++observed[light];
    flux += glm::dvec3(e.flux);
    worst = std::max(worst, std::abs(double(mean(e.flux)) * n / total - 1));
    worst = std::max(worst, std::abs(glm::length(Vec3d(e.direction)) - 1));
    bool const out = dot(e.direction, e.surface.n) > 0;
    wrongSide += flat.lights[light].side == (out ? Side::in : Side::out);
    both += flat.lights[light].side == Side::both;
    bothOut += flat.lights[light].side == Side::both && out;
  }
  glm::dvec3 radiated(0.0);
  for (const FlatLight& l : flat.lights) {
    expected.push_back(n * l.power / total);
    radiated += glm::dvec3(l.radiance) * M_PI * l.area * (l.side == Side::both ? 2.0 : 1.0);
  }
  CHECK(chiSquareP(observed, expected) > significance(2));
  CHECK(worst < 1e-5);
  CHECK(wrongSide == 0);
  CHECK(std::abs(bothOut - 0.5 * both) < 4 * std::sqrt(0.25 * both));
  for (int c = 0; c < 3; ++c) CHECK(flux[c] == doctest::Approx(radiated[c]).epsilon(0.02));
}

TEST_CASE("photons leave a light by Lambert's law") {
  SceneBuilder b;
  b.add(ShapeKind::sphere, scaling({1, 0.5, 2}), Emission{Rgb(1.0f), Side::out});
  HostScene const scene(flatten(b.scene));
  TestRandom random(2);
  Histogram2 histogram(16, 16);
  for (int i = 0; i < 50000; ++i) {
    Emitted const e = emitPhoton<F>(scene.view(), random.vec2().x, random.vec2(), random.vec2(), 1);
    Vec3 const local = Frame(e.surface.n).toLocal(e.direction);
    histogram.add(0.5 + std::atan2(double(local.y), double(local.x)) / (2 * M_PI), double(local.z) * double(local.z));
  }
  CHECK(histogram.uniformP() > significance(2));
}

TEST_CASE("picking a light rescales its number to the whole interval") {
  HostScene const scene(fourLights());
  const SceneView& view = scene.view();
  std::vector<std::vector<Real>> within(view.lights.size);
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    Real u = Real((i + 0.5) / n);
    within[pickLight(view, u)].push_back(u);
  }
  for (std::uint32_t l = 0; l < view.lights.size; ++l) {
    const std::vector<Real>& u = within[l];
    CHECK(std::abs(double(u.size()) - n * double(view.lights[l].pick)) < 2);
    CHECK((u.front() >= 0 && u.front() < 0.02f && u.back() > 0.98f && u.back() < 1));
    CHECK(std::is_sorted(u.begin(), u.end()));
  }
  for (Real u : {Real(0), std::nextafter(Real(1), Real(0))}) {
    CHECK(pickLight(view, u) < view.lights.size);
    CHECK((u >= 0 && u < 1));
  }
}

TEST_CASE("a light sample comes with the density that lightPdf gives its point") {
  HostScene const scene(fourLights());
  TestRandom random(3);
  double worst = 0;
  int useful = 0, wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    Surface from;
    from.p = Vec3(random.inBox(7));
    DirectSample const s = sampleLight<F>(scene.view(), from, random.vec2().x, random.vec2());
    if (s.pdf == 0) continue;
    ++useful;
    Surface on = s.surface;
    worst = std::max(worst, std::abs(double(lightPdf<F>(scene.view(), from.p, on, s.wi)) / double(s.pdf) - 1));
    wrong += s.radiance != scene.flat().lights[std::size_t(s.surface.light)].radiance ||
             s.surface.primitive != scene.flat().lights[std::size_t(s.surface.light)].primitive;
    wrong += glm::length(Vec3d(s.wi) - glm::normalize(Vec3d(s.surface.p) - Vec3d(from.p))) > 1e-5;
  }
  CHECK(useful > 5000);
  CHECK(worst < 0.01);
  CHECK(wrong == 0);
}

TEST_CASE("the irradiance of light samples is the closed form below a sphere") {
  SceneBuilder b;
  b.add(ShapeKind::sphere, translation({0, 0, 3}), Emission{Rgb(2.0f), Side::out});
  HostScene const scene(flatten(b.scene));
  TestRandom random(4);
  double sum = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    DirectSample const s = sampleLight<F>(scene.view(), Surface{}, random.vec2().x, random.vec2());
    if (s.pdf > 0) sum += double(s.radiance.x) * double(s.wi.z) / double(s.pdf) / n;
  }
  CHECK(sum == doctest::Approx(M_PI * 2 / 9).epsilon(0.005));  // π L (r/d)²
}
