// Photons aimed at specular surfaces against photons sent anywhere.

#include <doctest/doctest.h>

#include <cmath>

#include "measure/scenes/scene_kit.h"
#include "render/flatten/flatten.h"
#include "render/kernels/trace_photons.h"
#include "render/targets/specular_targets.h"
#include "render/upload/upload.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/rendering.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

std::vector<cpu::Target> targetsOf(const FlatScene& flat) {
  std::vector<cpu::Target> targets;
  for (const SpecularTarget& t : specularTargets(flat)) targets.push_back(cpu::toTarget(t));
  return targets;
}

bool meets(cpu::Target t, cpu::Vec3 p, cpu::Vec3 w) {
  Vec3d const d = Vec3d(t.center) - Vec3d(p);
  double const along = glm::dot(d, Vec3d(w)), r2 = double(t.radius) * double(t.radius);
  return glm::dot(d, d) < r2 || (along > 0 && glm::dot(d, d) - along * along < r2);
}

/// A mirror standing ring of `pieces` quads around the origin.
Scene mirrorRing(int pieces) {
  Scene scene = emptyScene(0.5f);
  int const mirror = addMaterial(scene, MirrorParams{Rgb(0.9f)});
  addQuad(scene, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
  for (int i = 0; i < pieces; ++i) {
    double const a = 2 * M_PI * i / pieces, b = 2 * M_PI * (i + 1) / pieces;
    Vec3d const p(std::cos(a), 0.01, std::sin(a)), q(std::cos(b), 0.01, std::sin(b));
    addQuad(scene, p, q - p, {0, 0.1, 0}, mirror);
  }
  addSphere(scene, {-2, 2, 0}, 0.05).emission = Emission{Rgb(1000), Side::out};
  return scene;
}

Scene glassOverFloor(bool lampInside) {
  Scene scene = emptyScene(0.7f);
  addQuad(scene, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
  addSphere(scene, {0, 0.6, 0}, 0.5, addMaterial(scene, DielectricParams{1.5f}));
  addSphere(scene, {1.5, 0.4, 0.2}, 0.3, addMaterial(scene, DielectricParams{2.0f}));
  Vec3d const corner = lampInside ? Vec3d(-0.1, 0.6, -0.1) : Vec3d(-0.5, 2, -0.5);
  double const size = lampInside ? 0.2 : 1;
  addQuad(scene, corner, {size, 0, 0}, {0, 0, size}).emission = Emission{Rgb(3, 2, 1), Side::both};
  return scene;
}

struct Flux {
  double caustic = 0, other = 0;  ///< watts
  double squares = 0;             ///< of caustic, path by path
  double spread = 0;              ///< standard error of caustic
};

Flux fluxOf(const Scene& scene, PhotonClass photons, std::uint32_t count) {
  HostScene const host(flatten(scene));
  std::vector<cpu::Target> const targets = targetsOf(flatten(scene));
  cpu::FrameView frame;
  frame.scene = host.view();
  frame.scene.targets = {targets.data(), std::uint32_t(targets.size())};
  frame.maxDepth = hardDepthLimit;
  frame.seed = 3;
  frame.photonClass = photons;
  Tally tally;
  Flux sum;
  for (std::uint32_t path = 0; path < count; ++path) {
    double ofPath = 0;
    cpu::tracePhotonPath<feature::all>(
        frame, path, cpu::Real(count),
        [&](std::uint32_t, const cpu::PhotonPosition&, const cpu::PhotonPower& power, cpu::Vec3) {
          double const flux = double(mean(power.flux));
          if (power.caustic())
            ofPath += flux;
          else
            sum.other += flux;
        },
        tally);
    sum.caustic += ofPath;
    sum.squares += ofPath * ofPath;
  }
  sum.spread = std::sqrt(std::max(0.0, sum.squares - sum.caustic * sum.caustic / count));
  return sum;
}

}  // namespace

TEST_CASE("the balls hold every corner of a specular surface, and a ring is a chain of small ones") {
  FlatScene const flat = flatten(mirrorRing(64));
  std::vector<SpecularTarget> const targets = specularTargets(flat);
  double area = 0;
  for (const SpecularTarget& t : targets) area += t.radius * t.radius;
  CHECK(targets.size() > 8);
  CHECK(targets.size() <= mostTargets);
  CHECK(area < 0.5);  // one ball around the ring has 1.02
  for (std::size_t i = 1; i < 65; ++i)
    for (Vec3d corner : flat.quads[i].corner)
      CHECK(std::any_of(targets.begin(), targets.end(),
                        [&](const SpecularTarget& t) { return glm::length(corner - t.center) <= t.radius; }));
  CHECK(specularTargets(flatten(glassOverFloor(false))).size() == 2);
  Scene mesh = emptyScene(0.5f);
  addMesh(mesh, sphereMesh(16), addMaterial(mesh, DielectricParams{1.5f}));
  CHECK(specularTargets(flatten(mesh)).size() == 1);
  CHECK(specularTargets(flatten(emptyScene(0.5f))).empty());
}

TEST_CASE("an aimed direction weighs what the targets cover of the cosine's hemisphere") {
  TestRandom random(5);
  for (int scene = 0; scene < 40; ++scene) {
    CAPTURE(scene);
    std::vector<cpu::Target> targets;
    int const count = 1 + int(random.below(6));
    for (int i = 0; i < count; ++i)
      targets.push_back({cpu::Vec3(random.inBox(1)), cpu::Real(std::pow(10, random.between(-1.5, 0)))});
    cpu::Vec3 const p(random.inBox(2)), n(random.direction());
    Span<const cpu::Target> const view{targets.data(), std::uint32_t(targets.size())};
    int const samples = 40000;
    double sum = 0, squares = 0, covered = 0;
    for (int i = 0; i < samples; ++i) {
      auto unit = [&] { return cpu::Real(random.between(0, 0.9999999)); };
      cpu::Aimed const a = cpu::aimAt(view, p, n, unit(), cpu::Vec2(unit(), unit()));
      sum += double(a.factor);
      squares += double(a.factor) * double(a.factor);
      cpu::Vec3 const w = cpu::Frame(n).toWorld(cpu::cosineHemisphere(cpu::Vec2(unit(), unit())));
      covered += std::any_of(targets.begin(), targets.end(), [&](cpu::Target t) { return meets(t, p, w); });
    }
    double const m = sum / samples, c = covered / samples;
    double const error = std::sqrt((squares / samples - m * m) / samples + c * (1 - c) / samples);
    CHECK(std::abs(m - c) < 4.5 * error + 1e-4);
  }
}

TEST_CASE("caustics have the same flux from photons of their own, and the others lack it") {
  // A lamp within glass sends all its light there: aiming changes nothing.
  for (auto const& [scene, gain] :
       {std::pair(mirrorRing(64), 3.0), std::pair(glassOverFloor(false), 1.5), std::pair(glassOverFloor(true), 0.98)}) {
    std::uint32_t const count = 200000;
    Flux const all = fluxOf(scene, PhotonClass::every, count), own = fluxOf(scene, PhotonClass::caustic, count),
               others = fluxOf(scene, PhotonClass::global, count);
    CHECK(own.other == 0);
    CHECK(others.caustic == 0);
    CHECK(others.other == doctest::Approx(all.other).epsilon(1e-9));
    CHECK(std::abs(own.caustic - all.caustic) < 4 * std::hypot(own.spread, all.spread));
    CHECK(own.spread * gain < all.spread);
  }
}

TEST_CASE("a target that is tiny or far is hit") {
  for (double distance : {1.0, 1e3, 1e6}) {
    CAPTURE(distance);
    cpu::Target const t{cpu::Vec3(0, 0, cpu::Real(distance)), cpu::Real(1e-3)};
    TestRandom random(6);
    for (int i = 0; i < 1000; ++i) {
      auto unit = [&] { return cpu::Real(random.between(0, 0.9999999)); };
      cpu::Aimed const a = cpu::aimAt({&t, 1}, cpu::Vec3(0), cpu::Vec3(0, 0, 1), unit(), cpu::Vec2(unit(), unit()));
      double const expected = 1e-6 / (distance * distance);
      CHECK(double(a.factor) == doctest::Approx(expected).epsilon(1e-3));
    }
  }
}
