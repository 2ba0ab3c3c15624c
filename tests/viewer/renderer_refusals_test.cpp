// What the window's renderer does where scenes and settings are refused.

#include <doctest/doctest.h>

#include "app/viewer/session/renderer.h"
#include "tests/viewer/renderer_waits.h"

namespace ropelight::view {

TEST_CASE("a scene that cannot be rendered leaves the old one, and says why") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 1); }));
  auto bad = std::make_shared<Scene>(*scene);
  bad->shapes[0].toWorld[3][0] = 1e300;  // beyond float
  renderer.setScene(bad, bad->camera);
  REQUIRE(waitFor([&] { return !renderer.problem().empty(); }));
  CHECK(renderer.scene() == scene);
  std::uint64_t const n = renderer.status(estimateA).pixelIterations;
  CHECK(waitFor([&] { return iterated(renderer, estimateA, n + 1); }));

  Settings wrong = settingsOf(Mode::path);
  wrong.aov = Aov::photonCount;  // path gathers none
  renderer.setSettings(estimateA, wrong);
  REQUIRE(waitFor([&] { return !renderer.status(estimateA).problem.empty(); }));
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  CHECK(waitFor([&] { return renderer.status(estimateA).problem.empty() && iterated(renderer, estimateA, 1); }));
}

TEST_CASE("settings that do not fit leave an estimate that says so, and another change brings it back") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  Settings tight = settingsOf(Mode::sppm);
  tight.photons = 200000;
  renderer.setSettings(estimateA, tight);
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 1); }));
  tight.gather = GatherBy::nearest;
  tight.photonMemory = 1;  // all photons at once need more
  renderer.setSettings(estimateA, tight);
  REQUIRE(waitFor([&] { return !renderer.status(estimateA).problem.empty(); }));
  CHECK(renderer.status(estimateA).problem.find("MiB") != std::string::npos);
  CameraDesc moved = scene->camera;
  moved.position.x += 0.1;
  renderer.setCamera(moved, renderer.sceneVersion());
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  tight.photonMemory = 0;
  renderer.setSettings(estimateA, tight);
  CHECK(waitFor([&] {
    EstimateStatus const s = renderer.status(estimateA);
    return s.problem.empty() && s.stats.settings.gather == GatherBy::nearest && iterated(renderer, estimateA, 1);
  }));
}

TEST_CASE("refused settings leave the old ones, which follow the camera and can be reset") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 1); }));
  Settings wrong = settingsOf(Mode::sppm);
  wrong.mode = Mode::path;
  wrong.aov = Aov::photonCount;
  renderer.setSettings(estimateA, wrong);
  REQUIRE(waitFor([&] { return !renderer.status(estimateA).problem.empty(); }));
  CameraDesc moved = scene->camera;
  moved.position.x += 0.1;
  renderer.setCamera(moved, renderer.sceneVersion());
  REQUIRE(waitFor([&] { return renderer.status(estimateA).camera == moved && iterated(renderer, estimateA, 3); }));
  renderer.reset();
  // What was iterated may still be from before the reset, whose film is empty for a moment.
  CHECK(waitFor([&] { return iterated(renderer, estimateA, 5) && !renderer.film(estimateA).first.pixels.empty(); }));
}

TEST_CASE("an estimate that cannot be had does not keep a scene from opening") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  Settings wrong = settingsOf(Mode::path);
  wrong.aov = Aov::photonCount;
  renderer.setSettings(estimateB, wrong);
  renderer.setEnabled(estimateB, true);
  renderer.setScene(scene, scene->camera);
  CHECK(waitFor([&] { return iterated(renderer, estimateA, 1); }));
  CHECK(renderer.problem().empty());
  CHECK(waitFor([&] { return !renderer.status(estimateB).problem.empty(); }));
}

}  // namespace ropelight::view
