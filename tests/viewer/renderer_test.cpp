// The estimates of the window, without a window.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "app/viewer/session/error_curve.h"
#include "app/viewer/session/estimate.h"
#include "app/viewer/session/renderer.h"
#include "tests/support/rendering.h"
#include "tests/viewer/renderer_waits.h"

namespace ropelight::view {
TEST_CASE("in lock step the window shows what a render without a window gives, bit for bit") {
  auto const scene = asset("cornell-caustics");
  Renderer renderer(onCpu, true);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  renderer.setScene(scene, scene->camera);
  for (int i = 1; i <= 4; ++i) {
    renderer.step(1);
    renderer.finishSteps();
    CHECK(renderer.status(estimateA).pixelIterations == std::uint64_t(i));
  }
  CHECK(equals(shownBy(renderer, estimateA), testing::renderImage(*scene, settingsOf(Mode::sppm), 4)));
  Settings const path = settingsOf(Mode::path, 24);
  renderer.setSettings(estimateA, path);
  renderer.step(2);
  renderer.finishSteps();
  CHECK(equals(shownBy(renderer, estimateA), testing::renderImage(*scene, path, 2)));
}

TEST_CASE("camera and settings start the film again, tone does not exist here") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 5); }));
  renderer.setCamera(scene->camera, renderer.sceneVersion());  // the same: nothing happens
  std::uint64_t const before = renderer.status(estimateA).pixelIterations;
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, before + 1); }));
  CameraDesc moved = scene->camera;
  moved.position.x += 0.2;
  renderer.setCamera(moved, renderer.sceneVersion());
  REQUIRE(waitFor([&] { return renderer.status(estimateA).camera == moved && iterated(renderer, estimateA, 2); }));
  renderer.setCamera(scene->camera, renderer.sceneVersion() + 1);  // of a scene that is not shown
  renderer.setPaused(true);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  REQUIRE(waitFor([&] { return renderer.status(estimateA).stats.settings.mode == Mode::path; }));
  CHECK(renderer.status(estimateA).camera == moved);
}

TEST_CASE("a paused renderer shows an iteration after a change, and steps when told") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 2); }));
  renderer.setPaused(true);
  Settings other = settingsOf(Mode::path);
  other.seed = 9;
  renderer.setSettings(estimateA, other);
  REQUIRE(
      waitFor([&] { return renderer.status(estimateA).stats.settings.seed == 9 && iterated(renderer, estimateA, 1); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  CHECK(renderer.status(estimateA).pixelIterations == 1);
  renderer.step(3);
  REQUIRE(waitFor([&] { return renderer.status(estimateA).pixelIterations == 4; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK(renderer.status(estimateA).pixelIterations == 4);
}

TEST_CASE("two estimates share the machine's time, and errors against a reference fall") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  renderer.setSettings(estimateB, settingsOf(Mode::sppm));
  renderer.setEnabled(estimateB, true);
  Settings truth = settingsOf(Mode::path);
  renderer.setReference(std::make_shared<const Image>(testing::renderImage(*scene, truth, 400)), "truth");
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] {
    EstimateStatus const a = renderer.status(estimateA), b = renderer.status(estimateB);
    return a.errors.size() >= 8 && b.errors.size() >= 8 && a.stats.seconds > 0.5 && b.stats.seconds > 0.5;
  }));
  EstimateStatus const a = renderer.status(estimateA), b = renderer.status(estimateB);
  CHECK(a.stats.seconds / b.stats.seconds == doctest::Approx(1).epsilon(0.5));
  CHECK(a.errors.back().relMse < 0.5 * a.errors.front().relMse);
  CHECK(a.slope < -0.4);
  CHECK(renderer.referenceStatus().problem.empty());
  renderer.setReference(std::make_shared<const Image>(Image(5, 5)), "small");
  CHECK(renderer.referenceStatus().problem.find("5 x 5") != std::string::npos);
}

TEST_CASE("a reference accumulates beside the estimate") {
  auto const scene = asset("cornell");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  renderer.setSettings(reference, settingsOf(Mode::path));
  renderer.setScene(scene, scene->camera);
  renderer.setEnabled(reference, true);
  REQUIRE(waitFor([&] {
    ReferenceStatus const r = renderer.referenceStatus();
    return r.image && r.iterations >= 8 && renderer.status(estimateA).errors.size() >= 3;
  }));
  CHECK(std::abs(testing::meanOf(*renderer.referenceStatus().image) - testing::meanOf(renderer.film(estimateA).first)) <
        0.1);
  renderer.clearReference();
  CHECK_FALSE(renderer.referenceStatus().present);
}

TEST_CASE("photons come with the pixels when they are wanted") {
  auto const scene = asset("cornell-caustics");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  renderer.wantPhotons(500);
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 1) && renderer.status(estimateA).photonCount == 500; }));
  std::vector<PhotonPoint> points(500);
  CHECK(renderer.copyPhotons(estimateA, points.data(), 500) == 500);
  CHECK(renderer.copyPhotons(estimateA, points.data(), 7) == 7);
  renderer.wantPhotons(0);
  CHECK(waitFor([&] { return renderer.status(estimateA).photonCount == 0; }));
}

TEST_CASE("dragging for long never stops the pictures, and ends at full size") {
  auto const scene = asset("cornell-caustics");
  Renderer renderer(onCpu);
  Settings slow = testing::settingsFor(Mode::sppm, 400, 300);
  slow.photons = 100000;
  renderer.setSettings(estimateA, slow);
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 2); }));
  CameraDesc camera = scene->camera;
  std::uint64_t const first = renderer.status(estimateA).pixelVersion;
  for (int i = 0; i < 100; ++i) {
    camera.position.x += 0.003;
    renderer.setCamera(camera, renderer.sceneVersion());
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  CHECK(renderer.status(estimateA).pixelVersion >= first + 2);
  REQUIRE(waitFor([&] { return renderer.status(estimateA).camera == camera && iterated(renderer, estimateA, 1); }));
  CHECK(renderer.status(estimateA).width == 400);
}

TEST_CASE("while paused, a new mode, photons and a reference show without a step") {
  auto const scene = asset("cornell-caustics");
  Renderer renderer(onCpu);
  renderer.setSettings(estimateA, settingsOf(Mode::path));
  renderer.setScene(scene, scene->camera);
  REQUIRE(waitFor([&] { return iterated(renderer, estimateA, 1); }));
  renderer.setPaused(true);
  renderer.setSettings(estimateA, settingsOf(Mode::sppm));
  REQUIRE(waitFor([&] {
    return renderer.status(estimateA).stats.settings.mode == Mode::sppm && iterated(renderer, estimateA, 1);
  }));
  renderer.wantPhotons(100);
  CHECK(waitFor([&] { return renderer.status(estimateA).photonCount == 100; }));
  renderer.setReference(std::make_shared<const Image>(testing::renderImage(*scene, settingsOf(Mode::path), 20)),
                        "truth");
  CHECK(waitFor([&] { return renderer.status(estimateA).errors.size() == 1; }));
  renderer.clearReference();
  CHECK(waitFor([&] { return renderer.status(estimateA).errors.empty(); }));
}

TEST_CASE("a draft costs less by the square of its scale, and keeps what it can of a small film") {
  Settings s = testing::settingsFor(Mode::sppm, 640, 480);
  s.photons = 1 << 18;
  Settings const draft = draftOf(s, {512, 512}, 4, {0.01, 0.002, 0.5});
  CHECK(draft.width == 160);
  CHECK(draft.height == 120);
  CHECK(draft.photons == (1 << 14));
  CHECK(draft.radius == doctest::Approx(0.04));
  CHECK(draft.causticRadius == doctest::Approx(0.008));
  s.radius = 0.5;
  s.photons = 100;
  s.width = 3;
  CHECK(draftOf(s, {512, 512}, 8, {0.01, 0.002, 0.5}).radius == doctest::Approx(4));
  CHECK(draftOf(s, {512, 512}, 8, {0.01, 0.002, 0.5}).photons == 100);
  CHECK(draftOf(s, {512, 512}, 8, {0.01, 0.002, 0.5}).width == 1);
}

TEST_CASE("an error curve is measured again when the reference improves, and leaves other sizes out") {
  ErrorCurve curve;
  Image picture(4, 4);
  for (Rgb& p : picture.pixels) p = Rgb(1.0f);
  for (double t : {1.0, 1.1, 2.0}) {
    if (curve.due(t)) curve.add(t, t, picture);
  }
  CHECK(curve.points().empty());
  Image truth = picture;
  for (Rgb& p : truth.pixels) p = Rgb(2.0f);
  curve.measure(Image(3, 3), 1);
  CHECK(curve.points().empty());
  curve.measure(truth, 2);
  REQUIRE(curve.points().size() == 2);  // 1.1 came too soon
  CHECK(curve.points()[0].relMse == doctest::Approx(1 / (4 + 0.04)));
  curve.measure(picture, 3);
  CHECK(curve.points()[1].relMse == 0);
  CHECK(std::isnan(curve.slope()));
}

}  // namespace ropelight::view
