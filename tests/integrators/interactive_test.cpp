// What a window needs of an integrator: restarts in place, interruption, pixels and photons to show, first-hit films.

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

#include "accel/kdtree/kd_tree.h"
#include "render/core/error.h"
#include "render/import/load.h"
#include "render/integrators/integrator.h"
#include "tests/support/rendering.h"

namespace ropelight::testing {
namespace {

Scene asset(const char* name) { return loadScene(std::string(ROPELIGHT_ASSETS) + "/" + name + ".json"); }

Settings smallSettings(Mode mode) {
  Settings s = settingsFor(mode, 40, 28);
  s.photons = 3000;
  return s;
}

const BackendChoice onCpu{BackendKind::cpu, 0, 0, false};

bool sameBits(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb)) == 0;
}

double difference(const Image& a, const Image& b) { return std::abs(meanOf(a) - meanOf(b)); }

}  // namespace

TEST_CASE("a restarted integrator renders the same bits as a new one") {
  Scene scene = asset("cornell-caustics");
  CameraDesc moved = scene.camera;
  moved.position += Vec3d(0.3, 0.1, -0.2);
  for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm}) {
    CAPTURE(nameOf(mode));
    auto const integrator = makeIntegrator(scene, smallSettings(mode), onCpu);
    REQUIRE(integrator->advance(3));
    Settings other = smallSettings(mode);
    other.width = 56;
    other.photons = 5000;
    other.seed = 5;
    other.maxDepth = 5;
    other.direct = DirectLight::photons;
    REQUIRE(integrator->restart(moved, other));
    CHECK(integrator->stats().iterations == 0);
    REQUIRE(integrator->advance(3));
    Scene again = scene;
    again.camera = moved;
    CHECK(sameBits(integrator->film(), renderImage(again, other, 3)));
    REQUIRE(integrator->restart(scene.camera, smallSettings(mode)));
    REQUIRE(integrator->advance(2));
    CHECK(sameBits(integrator->film(), renderImage(scene, smallSettings(mode), 2)));
  }
}

TEST_CASE("restart refuses what needs another integrator, and changes nothing then") {
  Scene const scene = asset("cornell");
  auto const integrator = makeIntegrator(scene, smallSettings(Mode::sppm), onCpu);
  REQUIRE(integrator->advance(2));
  Settings const before = smallSettings(Mode::sppm);
  Settings mode = before, aov = before, tree = before;
  mode.mode = Mode::path;
  aov.aov = Aov::depth;
  tree.accel = Accel::tree;
  CameraDesc lens = scene.camera, far = scene.camera;
  lens.apertureRadius = 0.1;        // other kernels
  far.position = Vec3d(0, 0, 1e6);  // the tree's margins were made for rays of a smaller world
  for (const Settings& s : {mode, aov, tree}) CHECK_FALSE(integrator->restart(scene.camera, s));
  for (const CameraDesc& c : {lens, far}) CHECK_FALSE(integrator->restart(c, before));
  CHECK(integrator->stats().iterations == 2);
  Settings wrong = before;
  wrong.width = wrong.height = 65536;
  CHECK_THROWS_AS(integrator->restart(scene.camera, wrong), Error);
  REQUIRE(integrator->advance(1));
  CHECK(sameBits(integrator->film(), renderImage(scene, before, 3)));
}

TEST_CASE("a camera far outside gets a tree with wider margins") {
  Scene scene = asset("cornell");
  Settings s = smallSettings(Mode::ray);
  s.accel = Accel::tree;
  auto const cache = makeSceneCache(scene);
  auto const near = makeIntegrator(scene, s, onCpu, nullptr, cache);
  auto const sharing = makeIntegrator(scene, s, onCpu, nullptr, cache);
  CHECK(near->tree() == sharing->tree());
  scene.camera.position = Vec3d(0, 1, 5000);
  scene.camera.verticalFov = 0.04;
  auto const far = makeIntegrator(scene, s, onCpu, nullptr, cache);
  CHECK(far->tree() != near->tree());
  REQUIRE(far->advance(4));
  Settings brute = s;
  brute.accel = Accel::brute;
  CHECK(sameBits(far->film(), renderImage(scene, brute, 4)));
}

TEST_CASE("an interrupted integrator stops soon, and a reset makes it whole") {
  Scene const scene = asset("cornell");
  Settings s = settingsFor(Mode::path, 512, 512);
  auto const integrator = makeIntegrator(scene, s, onCpu);
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    integrator->interrupt();
  });
  bool const finished = integrator->advance(100000);
  stopper.join();
  CHECK_FALSE(finished);
  CHECK_FALSE(integrator->advance(1));
  CHECK_FALSE(integrator->present());
  s.width = 40;
  s.height = 28;
  REQUIRE(integrator->restart(scene.camera, s));
  REQUIRE(integrator->advance(2));
  CHECK(sameBits(integrator->film(), renderImage(scene, s, 2)));
}

TEST_CASE("pixels to show are the film, row by row from the top") {
  Scene const scene = asset("cornell-caustics");
  auto const integrator = makeIntegrator(scene, smallSettings(Mode::sppm), onCpu);
  REQUIRE(integrator->advance(2));
  REQUIRE(integrator->present());
  Image const film = integrator->film();
  std::vector<float> pixels(film.pixels.size() * 4);
  integrator->copyPixels(pixels.data());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < film.pixels.size(); ++i)
    wrong += pixels[4 * i] != film.pixels[i].x || pixels[4 * i + 1] != film.pixels[i].y ||
             pixels[4 * i + 2] != film.pixels[i].z || pixels[4 * i + 3] != 1;
  CHECK(wrong == 0);
  CHECK(integrator->gpu() == -1);
}

TEST_CASE("photons to show carry all of the flux, and tell caustics from the rest") {
  Scene const scene = asset("cornell-caustics");
  auto const integrator = makeIntegrator(scene, smallSettings(Mode::sppm), onCpu);
  CHECK(integrator->presentPhotons(1000) == 0);
  REQUIRE(integrator->advance(1));
  std::uint64_t const stored = integrator->stats().photonsStored;
  std::uint32_t const n = integrator->presentPhotons(1u << 30);
  REQUIRE(n == stored);
  std::vector<PhotonPoint> points(n);
  integrator->copyPhotons(points.data(), n);
  std::size_t caustic = 0, outside = 0;
  for (const PhotonPoint& p : points) {
    caustic += p.caustic;
    outside += std::abs(p.position[0]) > 1.001f || p.position[1] < -0.001f || p.position[1] > 2.001f;
    CHECK(p.bounce >= 2);  // direct light is the shadow rays'
    CHECK(p.flux[0] >= 0);
  }
  CHECK(outside == 0);
  CHECK(caustic > n / 100);
  CHECK(caustic < n / 2);
  CHECK(integrator->presentPhotons(100) == 100);

  Scene const matt = asset("cornell");
  auto const plain = makeIntegrator(matt, smallSettings(Mode::sppm), onCpu);
  REQUIRE(plain->advance(1));
  points.resize(plain->presentPhotons(1u << 30));
  plain->copyPhotons(points.data(), std::uint32_t(points.size()));
  CHECK_FALSE(points.empty());
  for (const PhotonPoint& p : points) CHECK(p.caustic == 0);  // no specular surface, no caustic
}

TEST_CASE("first-hit films: normals are unit, depth is distance, albedo is the material's") {
  Scene scene = emptyScene(0.25f);
  addQuad(scene, Vec3d(-5, -5, 0), Vec3d(10, 0, 0), Vec3d(0, 10, 0));
  addSphere(scene, Vec3d(0, 0, 3), 0.5, addMaterial(scene, MirrorParams{Rgb(0.9f, 0.8f, 0.7f)}));
  lookAt(scene, Vec3d(0, 0, 8), Vec3d(0), Vec3d(0, 1, 0), 20);
  Settings s = settingsFor(Mode::ray, 33, 33);
  auto const filmOf = [&](Aov aov) {
    s.aov = aov;
    Image const film = renderImage(scene, s, 4);
    return film;
  };
  Image const depth = filmOf(Aov::depth), albedo = filmOf(Aov::albedo), normal = filmOf(Aov::normal);
  CHECK(depth.at(16, 16).x == doctest::Approx(4.5).epsilon(1e-3));
  double const corner = 8 / std::cos(std::atan(std::tan(10 * M_PI / 180) * std::sqrt(2.0) * 32 / 33));
  CHECK(depth.at(0, 0).x == doctest::Approx(corner).epsilon(2e-3));
  CHECK(albedo.at(0, 0).x == doctest::Approx(0.25));
  CHECK(albedo.at(16, 16).z == doctest::Approx(0.7));
  CHECK(normal.at(16, 16).z > 0.99f);
  CHECK(normal.at(1, 16).z == doctest::Approx(1));
  s.accel = Accel::brute;
  CHECK(filmOf(Aov::tests).at(3, 3).x == doctest::Approx(2));
  CHECK(filmOf(Aov::traversal).at(3, 3).x == doctest::Approx(2));
  s.accel = Accel::tree;
  CHECK(filmOf(Aov::tests).at(0, 0).x <= 2);
  CHECK(filmOf(Aov::traversal).at(0, 0).x >= 1 + filmOf(Aov::tests).at(0, 0).x);
}

TEST_CASE("the gather's own films: photons counted, and the radius that was searched") {
  Scene const scene = asset("cornell");
  Settings s = smallSettings(Mode::sppm);
  s.aov = Aov::gatherRadius;
  s.radius = 0.05;
  Stats stats;
  Image const radius = renderImage(scene, s, 1, &stats);
  CHECK(radius.at(20, 14).x == doctest::Approx(stats.radius * stats.settings.quadScale));
  s.gather = GatherBy::nearest;
  s.nearest = 3;
  Image const nearest = renderImage(scene, s, 1);
  CHECK(nearest.at(20, 14).x <= doctest::Approx(stats.radius));
  CHECK(meanOf(nearest) < meanOf(radius));
  s.gather = GatherBy::radius;
  s.aov = Aov::photonCount;
  Image const once = renderImage(scene, s, 1);
  s.photons *= 2;
  Image const twice = renderImage(scene, s, 1);
  CHECK(meanOf(twice) == doctest::Approx(2 * meanOf(once)).epsilon(0.05));
  s.photonMemory = 1;  // several chunks count together
  CHECK(difference(renderImage(scene, s, 1, &stats), twice) < 1e-4 * meanOf(twice));
  s.mode = Mode::path;
  CHECK_THROWS_AS(renderImage(scene, s, 1), Error);
}

}  // namespace ropelight::testing
