// The CUDA backend against the CPU. Needs a GPU; says so and passes where there is none.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/gpu/device.h"
#include "tests/oracle/scenes.h"
#include "tests/scenes/placed_meshes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

/// Share of pixels whose channels all agree to `relative` of the brighter one (and of a thousandth of the mean).
double agreeingShare(const Image& a, const Image& b, double relative) {
  double const floor = 1e-3 * meanOf(a);
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    bool agrees = true;
    for (int c = 0; c < 3; ++c) {
      double const x = double(a.pixels[i][c]), y = double(b.pixels[i][c]);
      agrees = agrees && std::abs(x - y) <= relative * std::max({std::abs(x), std::abs(y), floor});
    }
    agreeing += agrees;
  }
  return double(agreeing) / double(a.pixels.size());
}

std::vector<oracle::Scene> scenes() {
  return {oracle::diffuseBox(96, 96), oracle::boxSpheresDiffuse(96, 96), oracle::pool(96, 96),
          oracle::touchingRoom(96, 96, 0)};
}

Settings settingsOf(Mode mode, Accel accel) {
  Settings s = settingsFor(mode, 96, 96);
  s.photons = 32768;
  s.accel = accel;
  return s;
}

}  // namespace

TEST_SUITE("gpu") {
  TEST_CASE("CUDA: one iteration equals the CPU's in 99 of 100 pixels") {
    if (noGpu()) return;
    for (const oracle::Scene& scene : scenes())
      for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm})
        for (Accel const accel : {Accel::brute, Accel::bvh, Accel::tree, Accel::shortStack}) {
          CAPTURE(nameOf(mode));
          CAPTURE(nameOf(accel));
          Settings const settings = settingsOf(mode, accel);
          Image const cpu = renderImage(fromOracle(scene), settings, 1, nullptr, onCpu);
          Image const gpu = renderImage(fromOracle(scene), settings, 1, nullptr, onGpu);
          CHECK(agreeingShare(cpu, gpu, 1e-4) >= 0.99);
        }
  }

  TEST_CASE("CUDA: meshes that stand in many places look as on the CPU") {
    if (noGpu()) return;
    Scene scene = placedBalls();
    scene.camera.position = {0.3, 0.4, 3.5};
    for (Accel const accel : {Accel::brute, Accel::bvh, Accel::tree, Accel::shortStack}) {
      CAPTURE(nameOf(accel));
      for (Aov const aov : {Aov::depth, Aov::normal}) {
        Settings settings = settingsOf(Mode::ray, accel);
        settings.aov = aov;
        Image const cpu = renderImage(scene, settings, 1, nullptr, onCpu);
        Image const gpu = renderImage(scene, settings, 1, nullptr, onGpu);
        CHECK(meanOf(cpu) != 0);
        CHECK(agreeingShare(cpu, gpu, 1e-3) >= 0.99);
      }
    }
  }

  TEST_CASE("CUDA: 64 iterations agree with the CPU's by tiles") {
    if (noGpu()) return;
    for (const oracle::Scene& scene : scenes())
      for (Mode const mode : {Mode::path, Mode::sppm}) {
        CAPTURE(nameOf(mode));
        Settings const settings = settingsOf(mode, Accel::automatic);
        TileStatistics const cpu = tileStatistics(renderSeeds(fromOracle(scene), settings, 16, 4, onCpu), 16);
        TileStatistics const gpu = tileStatistics(renderSeeds(fromOracle(scene), settings, 16, 4, onGpu), 16);
        CHECK(disagreement(gpu, cpu, 0.005) == "");
      }
  }

  TEST_CASE("CUDA: the same run gives the same bits") {
    if (noGpu()) return;
    for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm}) {
      CAPTURE(nameOf(mode));
      Scene const scene = fromOracle(oracle::boxSpheresDiffuse(96, 96));
      Image const a = renderImage(scene, settingsOf(mode, Accel::tree), 20, nullptr, onGpu);
      Image const b = renderImage(scene, settingsOf(mode, Accel::tree), 20, nullptr, onGpu);
      CHECK(std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb)) == 0);
    }
  }

  TEST_CASE("CUDA: k nearest, photons' direct light and a lens agree with the CPU") {
    if (noGpu()) return;
    Scene scene = fromOracle(oracle::diffuseBox(96, 96));
    Settings nearest = settingsOf(Mode::sppm, Accel::automatic), direct = nearest;
    nearest.gather = GatherBy::nearest;
    direct.direct = DirectLight::photons;
    CHECK(agreeingShare(renderImage(scene, nearest, 1, nullptr, onCpu), renderImage(scene, nearest, 1, nullptr, onGpu),
                        1e-4) >= 0.99);
    CHECK(agreeingShare(renderImage(scene, direct, 1, nullptr, onCpu), renderImage(scene, direct, 1, nullptr, onGpu),
                        1e-4) >= 0.99);
    scene.camera.apertureRadius = 0.1;
    CHECK(agreeingShare(renderImage(scene, direct, 1, nullptr, onCpu), renderImage(scene, direct, 1, nullptr, onGpu),
                        1e-4) >= 0.99);
  }

  TEST_CASE("CUDA: photons that do not fit are traced again, and in chunks, without loss") {
    if (noGpu()) return;
    Scene scene = emptyScene(0.95f);
    addBox(scene, {-1, -1, -1}, {1, 1, 1});
    addSphere(scene, {0, 0.5, 0}, 0.1).emission = Emission{Rgb(1), Side::out};
    lookAt(scene, {0, 0, 0.9}, {0, 0, 0}, {0, 1, 0}, 60);
    Settings settings = settingsOf(Mode::sppm, Accel::automatic);
    settings.photons = 200000;
    Stats stats;
    Image const atOnce = renderImage(scene, settings, 3, &stats, onGpu);
    CHECK(stats.regrown >= 1);
    CHECK(double(stats.photonsStored) / double(stats.photonPaths) == doctest::Approx(19).epsilon(0.03));
    settings.photonMemory = 64;
    Image const inChunks = renderImage(scene, settings, 3, &stats, onGpu);
    CHECK(stats.chunks > 1);
    CHECK(agreeingShare(atOnce, inChunks, 1e-4) == 1);
  }

  TEST_CASE("CUDA: what a scene does not need is not allocated and not launched") {
    if (noGpu()) return;
    Scene dark = emptyScene(0.5f);
    addBox(dark, {-1, -1, -1}, {1, 1, 1});
    Stats s;
    renderImage(dark, settingsOf(Mode::sppm, Accel::automatic), 2, &s, onGpu);
    for (const char* purpose : {"photons", "photon paths", "grid", "gather points", "lights", "tree", "scan and sort"})
      CHECK_MESSAGE(s.bytes.count(purpose) == 0, purpose);
    for (const char* stage : {"TracePhotons", "TraceTails", "Sort", "Scan", "GatherRadius"})
      CHECK_MESSAGE(s.launches.count(stage) == 0, stage);
  }
}
