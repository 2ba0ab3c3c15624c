// What an integrator promises besides the right mean: the same bits, room for its photons, nothing it does not need.

#include <doctest/doctest.h>

#include <cstring>

#include "render/core/error.h"
#include "tests/oracle/scenes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb)) == 0;
}

double largestDifference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(double(a.pixels[i][c]) - double(b.pixels[i][c])));
  return largest;
}

Scene openRoom() { return fromOracle(oracle::boxSpheresDiffuse(40, 30)); }

/// Long paths, so that the first guess of room for photons is too small.
Scene brightRoom() {
  Scene scene = emptyScene(0.95f);
  addBox(scene, {-1, -1, -1}, {1, 1, 1});
  addSphere(scene, {0, 0.5, 0}, 0.1).emission = Emission{Rgb(1), Side::out};
  lookAt(scene, {0, 0, 0.9}, {0, 0, 0}, {0, 1, 0}, 60);
  return scene;
}

Settings small(Mode mode) {
  Settings s = settingsFor(mode, 40, 30);
  s.photons = 20000;
  return s;
}

}  // namespace

TEST_CASE("the image does not depend on the number of threads") {
  for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm}) {
    CAPTURE(nameOf(mode));
    Image const one = renderImage(openRoom(), small(mode), 3, nullptr, {BackendKind::cpu, 0, 1, false});
    for (int threads : {2, 3, 5}) {
      CAPTURE(threads);
      CHECK(sameBits(one, renderImage(openRoom(), small(mode), 3, nullptr, {BackendKind::cpu, 0, threads, false})));
    }
  }
}

TEST_CASE("the image does not depend on how iterations are asked for, and reset starts again") {
  auto const integrator = makeIntegrator(openRoom(), small(Mode::sppm), {BackendKind::cpu, 0, 0, false});
  integrator->advance(5);
  Image const atOnce = integrator->film();
  integrator->reset();
  CHECK(integrator->stats().iterations == 0);
  CHECK(meanOf(integrator->film()) == 0);
  for (int i : {1, 1, 3}) integrator->advance(i);
  CHECK(sameBits(atOnce, integrator->film()));
  CHECK(integrator->stats().iterations == 5);
  CHECK(integrator->stats().photonPaths == 5 * 20000);
}

TEST_CASE("seeds differ") {
  Settings settings = small(Mode::sppm);
  Image const a = renderImage(openRoom(), settings, 2);
  settings.seed = 1ull << 40;
  CHECK(largestDifference(a, renderImage(openRoom(), settings, 2)) > 0);
}

TEST_CASE("photons that do not fit are traced again after growing, and none is lost") {
  Stats stats;
  Settings settings = small(Mode::sppm);
  Image const grown = renderImage(brightRoom(), settings, 4, &stats);
  CHECK(stats.regrown >= 1);
  CHECK(stats.iterations == 4);
  // An albedo of 0.95 stores 1/(1 − 0.95) photons a path, less the direct one that shadow rays have.
  CHECK(double(stats.photonsStored) / double(stats.photonPaths) == doctest::Approx(19).epsilon(0.03));
  settings.photons = 5000;  // four times as many iterations of a quarter: the same mean
  settings.radius = stats.firstRadius;
  CHECK(meanOf(renderImage(brightRoom(), settings, 16)) == doctest::Approx(meanOf(grown)).epsilon(0.02));
}

TEST_CASE("an iteration in chunks is the iteration at once") {
  Settings settings = small(Mode::sppm);
  settings.photons = 200000;
  Image const atOnce = renderImage(openRoom(), settings, 2);
  settings.photonMemory = 16;
  Stats stats;
  Image const inChunks = renderImage(openRoom(), settings, 2, &stats);
  CHECK(stats.chunks > 1);
  CHECK(largestDifference(atOnce, inChunks) < 1e-4);
  settings.gather = GatherBy::nearest;
  CHECK_THROWS_WITH_AS(renderImage(openRoom(), settings, 1), doctest::Contains("k-nearest"), Error);
}

TEST_CASE("what a scene does not need is not allocated and not launched") {
  Scene dark = emptyScene(0.5f);
  addBox(dark, {-1, -1, -1}, {1, 1, 1});
  lookAt(dark, {0, 0, 0.5}, {0, 0, 0}, {0, 1, 0}, 60);
  Stats s;
  renderImage(dark, small(Mode::sppm), 2, &s);
  for (const char* purpose :
       {"photons", "photon paths", "grid", "gather points", "lights", "spheres", "triangles", "tree"})
    CHECK_MESSAGE(s.bytes.count(purpose) == 0, purpose);
  for (const char* stage : {"TracePhotons", "TraceTails", "Sort", "Scan", "OrderPhotons", "GatherRadius"})
    CHECK_MESSAGE(s.launches.count(stage) == 0, stage);
  CHECK(s.shadowRays == 0);
  CHECK(s.photonPaths == 0);
  CHECK(s.launches.at("TraceCamera") == 2);

  renderImage(openRoom(), small(Mode::ray), 1, &s);
  CHECK(s.bytes.count("photons") + s.bytes.count("grid") + s.bytes.count("gather points") == 0);
  CHECK(s.bytes.count("tree") + s.bytes.count("triangles") == 0);
  CHECK(s.kernelRow == "basic");

  Settings tree = small(Mode::sppm);
  tree.accel = Accel::tree;
  renderImage(openRoom(), tree, 1, &s);
  CHECK(s.bytes.at("tree") > 0);
  CHECK(s.bytes.at("photons") > 0);
  CHECK(s.kernelRow == "all");
}

TEST_CASE("a tree changes nothing in the image") {
  Settings settings = small(Mode::sppm);
  settings.accel = Accel::brute;
  Image const brute = renderImage(openRoom(), settings, 2);
  settings.accel = Accel::tree;
  CHECK(sameBits(brute, renderImage(openRoom(), settings, 2)));
  settings.split = SplitBy::midpoint;
  CHECK(sameBits(brute, renderImage(openRoom(), settings, 2)));
}

TEST_CASE("up is up and left is left") {
  // Four emitting quads in the image's quarters: red top left, green top right, blue bottom left, white bottom right.
  Scene scene = emptyScene(0);
  Rgb const colours[4] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  for (int i = 0; i < 4; ++i)
    addQuad(scene, {i % 2 ? 0.1 : -0.9, i < 2 ? 0.1 : -0.9, 0}, {0.8, 0, 0}, {0, 0.8, 0}).emission =
        Emission{colours[i], Side::out};
  lookAt(scene, {0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 53.13);
  Image const image = renderImage(scene, settingsFor(Mode::ray, 40, 40), 1);
  CHECK(image.at(10, 10) == colours[0]);
  CHECK(image.at(30, 10) == colours[1]);
  CHECK(image.at(10, 30) == colours[2]);
  CHECK(image.at(30, 30) == colours[3]);
}

TEST_CASE("a thin lens blurs what is out of focus and keeps what is in focus") {
  Scene scene = emptyScene(0);
  addQuad(scene, {-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}).emission = Emission{Rgb(1), Side::out};
  lookAt(scene, {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 30);
  scene.camera.apertureRadius = 0.5;
  auto const grey = [&](double focus) {  // pixels that are neither black nor white
    scene.camera.focusDistance = focus;
    int count = 0;
    for (Rgb p : renderImage(scene, settingsFor(Mode::ray, 48, 48), 32).pixels) count += p.x > 0.02f && p.x < 0.98f;
    return count;
  };
  CHECK(grey(4) < 200);
  CHECK(grey(2) > 600);
}

TEST_CASE("photons do not leak through a thin wall") {
  // Two rooms share a floor; a wall of 0.002 stands between them and the light is in one of them.
  Scene scene = emptyScene(0.8f);
  addBox(scene, {-1, 0, -1}, {1, 1, 1});
  addBox(scene, {-0.001, 0, -1}, {0.001, 1, 1});
  addSphere(scene, {0.5, 0.5, 0}, 0.1).emission = Emission{Rgb(10), Side::out};
  lookAt(scene, {-0.5, 0.5, 0}, {0, 0.5, 0}, {0, 1, 0}, 30);  // the wall alone, from the dark room
  Settings settings = small(Mode::sppm);
  settings.radius = 0.05;
  CHECK(meanOf(renderImage(scene, settings, 4)) == 0);
}

TEST_CASE("settings that contradict the program are refused") {
  Settings settings = small(Mode::sppm);
  settings.mode = Mode::path;
  settings.aov = Aov::photonCount;
  CHECK_THROWS_WITH_AS(renderImage(openRoom(), settings, 1), doctest::Contains("--aov photon-count: only --mode sppm"),
                       Error);
}
