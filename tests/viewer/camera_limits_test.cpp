// The viewer's camera always stays one that a scene may hold, whatever is done to it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/camera/camera_control.h"
#include "render/camera/camera.h"
#include "tests/support/test_random.h"
#include "tests/viewer/camera_moves.h"

using namespace ropelight;
using namespace ropelight::view;

TEST_CASE("the limits of a scene's coordinates hold") {
  CameraControl control = sized(1e12);
  for (int i = 0; i < 1000; ++i) control.fly({1, 1, -1}, 5), control.pan(3, 3);
  checkUsable(control.camera());
  control.speed = 1e300;
  control.fly({1, 1, 1}, 1e300);
  checkUsable(control.camera());
}

TEST_CASE("focus 0 stays the distance to the target, and lens and angle keep to their limits") {
  CameraControl control = sized(1);
  control.orbit(1, 0.1), control.dolly(0.5), control.pan(1, 1), control.frame(cube(2), 1), control.fly({1, 0, 0}, 1);
  CHECK(control.camera().focusDistance == 0);
  control.setFocusDistance(-1);
  CHECK(control.camera().focusDistance == 0);
  control.setFocusDistance(2.5);
  control.orbit(1, 0.1);
  CHECK(control.camera().focusDistance == 2.5);
  control.setFov(1000);
  CHECK(control.camera().verticalFov == maxFov);
  control.setFov(-5);
  CHECK(control.camera().verticalFov == minFov);
  control.setAperture(1e300);
  CHECK(control.camera().apertureRadius == maxCoordinate);
  control.setAperture(-1);
  CHECK(control.camera().apertureRadius == 0);
}

TEST_CASE("numbers that are not finite change nothing") {
  for (double bad : {notANumber, infinite, -infinite}) {
    CameraControl control = sized(1);
    CameraDesc const before = control.camera();
    control.orbit(bad, 0), control.orbit(0, bad), control.pan(bad, 0), control.pan(0, bad), control.dolly(bad);
    control.look(bad, 0), control.look(0, bad), control.fly({0, bad, 0}, 1), control.fly({1, 0, 0}, bad);
    control.setFov(bad), control.setAperture(bad), control.setFocusDistance(bad);
    control.setCamera(cameraAt({bad, 0, 0}));
    control.setCamera(cameraAt({1, 0, 0}, {0, bad, 0}));
    control.speed = bad;
    control.fly({1, 0, 0}, 1);
    CHECK(control.camera() == before);
    checkNear(control.directionThrough(bad, 0, 1), forward(before), 1e-15);
    control.setHome(cameraAt({bad, 0, 0}), cube(bad));
    checkUsable(control.camera());
  }
}

TEST_CASE("cameras without a direction are mended") {
  for (double size : sizes)
    for (Vec3d position : {Vec3d(0), Vec3d(1, 2, 3) * size, Vec3d(maxCoordinate), Vec3d(-maxCoordinate)}) {
      CameraControl control = sized(size);
      control.setCamera(cameraAt(position, position));
      CHECK(control.camera().position == position);
      checkUsable(control.camera());
      for (Vec3d up : {Vec3d(0), Vec3d(0, 0, 2), Vec3d(0, 0, -1e-200)}) {
        CameraDesc along = cameraAt(Vec3d(0, 0, size), Vec3d(0));
        along.up = up;
        control.setCamera(along);
        checkUsable(control.camera());
      }
      control.orbit(0.1, 0.1), control.dolly(1), control.look(0.1, 0.1);
      checkUsable(control.camera());
    }
}

TEST_CASE("a random walk of the camera stays usable") {
  TestRandom random(3);
  for (double size : sizes) {
    CameraControl control = sized(size);
    for (int i = 0; i < 3000; ++i) {
      double const a = random.between(-2, 2), b = random.between(-2, 2);
      switch (random.below(6)) {
        case 0:
          control.orbit(a, b);
          break;
        case 1:
          control.pan(a, b);
          break;
        case 2:
          control.dolly(4 * a);
          break;
        case 3:
          control.look(a, b);
          break;
        case 4:
          control.fly({a, b, a}, 1);
          break;
        default:
          control.setFov(90 * std::abs(a));
      }
    }
    checkUsable(control.camera());
    cpu::CameraView const v = cpu::makeCamera(control.camera(), 7, 5);
    CHECK(std::isfinite(v.forward.x + v.right.x + v.up.x + v.position.x));
  }
}

TEST_CASE("a camera that starts nearer to a pole does not jump away from it") {
  CameraControl control = controlOf(cameraAt({0, 5, 1e-4}));
  CameraDesc const before = control.camera();
  control.orbit(0, 0.1);
  checkNear(control.camera().position, before.position, 1e-12);
  control.orbit(0, -0.1);
  CHECK(std::asin(control.camera().position.y / 5) == doctest::Approx(M_PI / 2 - 2e-5 - 0.1));
}
