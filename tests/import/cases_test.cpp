// Small inputs that were wrong without a word, with their right values: tests/cases/.

#include <doctest/doctest.h>

#include "render/import/load.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

Scene load(const std::string& name) { return loadScene(std::string(ROPELIGHT_ASSETS) + "/../tests/cases/" + name); }

/// Mean over the film of the scene.
double seen(const Scene& scene, Mode mode, const BackendChoice& backend, int iterations, Aov aov = Aov::radiance,
            std::uint64_t photons = 30000) {
  Settings settings = settingsFor(mode, scene.film.width, scene.film.height);
  settings.aov = aov;
  settings.photons = photons;
  return meanOf(renderImage(scene, settings, iterations, nullptr, backend));
}

struct Expected {
  const char* file;
  double value, tolerance;
};

}  // namespace

TEST_CASE("cases: glass on a floor, touching glass, lights in a ceiling, a small lamp and a far furnace" *
          doctest::test_suite("slow")) {
  constexpr Expected rows[] = {{"glass-on-floor.json", 1, 0.01},   {"touching-glass.json", 1, 0.01},
                               {"panel_first.json", 0.499, 0.005}, {"panel_last.json", 0.499, 0.005},
                               {"small-lamp.json", 0.25, 0.005},   {"box_far1e6.json", 2, 0.01}};
  for (const BackendChoice& backend : everyBackend())
    for (const Expected& row : rows)
      for (Mode const mode : {Mode::path, Mode::sppm}) {
        CAPTURE(nameOf(backend.backend));
        CAPTURE(row.file);
        CAPTURE(nameOf(mode));
        CHECK(seen(load(row.file), mode, backend, 32) == doctest::Approx(row.value).epsilon(row.tolerance));
      }
}

TEST_CASE("cases: a doorway in one polygon stays open") {
  for (const BackendChoice& backend : everyBackend())
    CHECK(seen(load("door.json"), Mode::path, backend, 16, Aov::albedo) == doctest::Approx(0.3541).epsilon(0.005));
}

TEST_CASE("cases: a ring at map coordinates looks like the same ring at the origin") {
  for (const BackendChoice& backend : everyBackend())
    for (Mode const mode : {Mode::path, Mode::sppm}) {
      auto const tiles = [&](const char* file) {
        Settings settings = settingsFor(mode, 48, 48);
        settings.photons = 20000;
        return tileStatistics(renderSeeds(load(file), settings, 8, 6, backend), 16);
      };
      CAPTURE(nameOf(mode));
      CHECK(disagreement(tiles("utm.obj"), tiles("local.obj"), 0.01) == "");
    }
}

TEST_CASE("cases: lines that go on, comments and byte order marks are read") {
  CHECK(load("continuation.obj").meshes[0].triangles.size() == 3);
  CHECK(load("comment.obj").meshes[0].triangles.size() == 2);
  Mesh const square = load("bom_shift.obj").meshes[0];
  REQUIRE(square.triangles.size() == 2);
  CHECK(square.positions[0] == Vec3d(0, 0, 0));
  CHECK(square.triangles[1] == glm::uvec3(0, 2, 3));
}
