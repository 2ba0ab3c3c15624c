// The modes against each other and against a second path tracer that shares no code with them.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "render/film/metrics.h"
#include "render/image_files/exr.h"
#include "render/import/load.h"
#include "tests/oracle/scenes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

constexpr int size = 64, tile = 16;

struct Case {
  const char* name;
  oracle::Scene scene;
};

std::vector<Case> cases() {
  return {{"diffuse box", oracle::diffuseBox(size, size)},
          {"box with spheres", oracle::boxSpheresDiffuse(size, size)},
          {"pool", oracle::pool(size, size)}};
}

Settings progressive() {
  Settings s = settingsFor(Mode::sppm, size, size);
  s.photons = 131072;
  s.radius = 0.012;
  return s;
}

/// The oracle's tiles as statistics of one rendering with known errors.
TileStatistics oracleTiles(const oracle::Scene& scene, int samples, bool indirect) {
  oracle::Options options;
  options.indirectOnly = indirect;
  std::vector<double> variance;
  auto const image = oracle::render(scene, samples, 11, 0, options, &variance);
  TileStatistics out;
  for (const oracle::TileMean& t : oracle::tileMeans(image, variance, size, tile)) {
    double const error = std::sqrt(t.variance);
    out.mean.push_back({t.mean[0], t.mean[1], t.mean[2]});
    out.error.push_back({error, error, error});
  }
  return out;
}

/// The 32×32 tiles of a 512×512 image without those of the spheres, their edges and the caustics below them, and
/// without the caustic on the ceiling, where the reference is 1 to 2% below both of our path tracers
/// (docs/benchmarks/first-light.md).
TileStatistics awayFromSpheres(const TileStatistics& all) {
  TileStatistics out;
  for (std::size_t t = 0; t < all.mean.size(); ++t) {
    std::size_t const x = t % 16, y = t / 16;
    bool const spheres = y >= 9 && x >= 3 && x <= 13, ceiling = (y == 1 || y == 2) && x >= 10 && x <= 13;
    if (spheres || ceiling) continue;
    out.mean.push_back(all.mean[t]);
    out.error.push_back(all.error[t]);
  }
  return out;
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("indirect light of sppm, path and the oracle agrees tile by tile") {
    for (const Case& c : cases()) {
      std::string const name = c.name;
      CAPTURE(name);
      Scene const scene = fromOracle(c.scene);
      Settings path = settingsFor(Mode::path, size, size);
      path.indirectOnly = true;
      Settings sppm = progressive();
      sppm.indirectOnly = true;
      TileStatistics const byPath = tileStatistics(renderSeeds(scene, path, 96, 8), tile);
      TileStatistics const bySppm = tileStatistics(renderSeeds(scene, sppm, 24, 8), tile);
      TileStatistics const byOracle = oracleTiles(c.scene, 400, true);
      CHECK(disagreement(bySppm, byPath, 0.02) == "");
      CHECK(disagreement(byPath, byOracle, 0.02) == "");
      CHECK(disagreement(bySppm, byOracle, 0.02) == "");
    }
  }

  TEST_CASE("the whole light of sppm, path and the oracle agrees tile by tile") {
    for (const Case& c : cases()) {
      std::string const name = c.name;
      CAPTURE(name);
      Scene const scene = fromOracle(c.scene);
      TileStatistics const byPath =
          tileStatistics(renderSeeds(scene, settingsFor(Mode::path, size, size), 96, 8), tile);
      TileStatistics const bySppm = tileStatistics(renderSeeds(scene, progressive(), 24, 8), tile);
      TileStatistics const byOracle = oracleTiles(c.scene, 400, false);
      CHECK(disagreement(bySppm, byPath, 0.02) == "");
      CHECK(disagreement(byPath, byOracle, 0.02) == "");
      CHECK(disagreement(bySppm, byOracle, 0.02) == "");
    }
  }

  TEST_CASE("box-spheres-diffuse agrees with the outside reference") {
    std::filesystem::path const file =
        std::filesystem::path(ROPELIGHT_SHARED_DATA) / "references" / "box-spheres-diffuse.exr";
    if (!std::filesystem::exists(file)) {
      MESSAGE("skipped: " << file.string() << " is not here");
      return;
    }
    Image const reference = readExr(file.string());
    Scene const scene = loadScene(std::string(ROPELIGHT_ASSETS) + "/box-spheres-diffuse.json");
    Settings settings = settingsFor(Mode::sppm, 512, 512);
    settings.photons = 1u << 20;
    settings.radius = 0.004;  // small: discs cut by the room's edges darken the tiles along them
    std::vector<Image> const images = renderSeeds(scene, settings, 4, 4);
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0;
      for (const Image& image : images) sum += compareImages(image, reference).mean[c];
      CHECK(sum / double(images.size()) ==
            doctest::Approx(compareImages(images[0], reference).meanReference[c]).epsilon(0.005));
    }
    TileStatistics const ours = awayFromSpheres(tileStatistics(images, 32));
    CHECK(ours.mean.size() > 150);
    // Tiles are within 2% after seconds on a GPU; the few photons of a test leave more noise than that.
    CHECK(disagreement(ours, awayFromSpheres(tileStatistics({reference}, 32)), 0.03) == "");
  }
}

TEST_CASE("ray is sppm without its photons") {
  Scene const scene = fromOracle(oracle::diffuseBox(48, 32));
  Settings direct = settingsFor(Mode::path, 48, 32);
  direct.maxDepth = 2;
  double const byPath = meanOf(renderImage(scene, direct, 256));
  CHECK(meanOf(renderImage(scene, settingsFor(Mode::ray, 48, 32), 64)) == doctest::Approx(byPath).epsilon(0.01));
}

TEST_CASE("a depth limit means the same in path and sppm" * doctest::test_suite("slow")) {
  Scene const scene = fromOracle(oracle::boxSpheresDiffuse(32, 32));
  for (int depth : {2, 3, 4, 6}) {
    CAPTURE(depth);
    Settings path = settingsFor(Mode::path, 32, 32), sppm = progressive();
    sppm.width = sppm.height = 32;
    path.maxDepth = sppm.maxDepth = depth;
    double const expected = meanOf(renderImage(scene, path, 512));
    CHECK(meanOf(renderImage(scene, sppm, 8)) == doctest::Approx(expected).epsilon(0.03));
  }
}

TEST_CASE("k nearest and a fixed radius estimate the same light" * doctest::test_suite("slow")) {
  Scene const scene = fromOracle(oracle::diffuseBox(48, 48));
  Settings radius = progressive();
  radius.width = radius.height = 48;
  radius.radius = 0.05;
  Settings nearest = radius;
  nearest.gather = GatherBy::nearest;
  nearest.nearest = 20;
  double const expected = meanOf(renderImage(scene, radius, 8));
  CHECK(meanOf(renderImage(scene, nearest, 8)) == doctest::Approx(expected).epsilon(0.02));
  nearest.nearest = 3;
  CHECK(meanOf(renderImage(scene, nearest, 8)) == doctest::Approx(expected).epsilon(0.02));
}
