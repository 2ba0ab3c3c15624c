// The viewer's camera: what each move keeps and changes.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/camera/camera_control.h"
#include "render/camera/camera.h"
#include "render/import/load.h"
#include "tests/support/scene_files.h"
#include "tests/support/test_random.h"
#include "tests/viewer/camera_moves.h"

using namespace ropelight;
using namespace ropelight::view;

TEST_CASE("orbit keeps target and distance and turns by its angle") {
  for (double size : sizes) {
    CAPTURE(size);
    CameraControl control = sized(size);
    CameraDesc const before = control.camera();
    control.orbit(0.3, 0.2);
    const CameraDesc& after = control.camera();
    CHECK(after.target == before.target);
    CHECK(distance(after) == doctest::Approx(distance(before)).epsilon(1e-14));
    CHECK(glm::dot(after.position - before.position, right(before)) > 0);
    CHECK(after.position.y > before.position.y);
    Vec3d const a = forward(before), b = forward(after);
    CHECK(std::atan2(b.x, b.z) - std::atan2(a.x, a.z) == doctest::Approx(0.3));
    CHECK(std::asin(-b.y) - std::asin(-a.y) == doctest::Approx(0.2));
  }
}

TEST_CASE("orbits there and back, and all round, return") {
  CameraControl control = sized(1);
  CameraDesc const before = control.camera();
  for (int i = 0; i < 1000; ++i) control.orbit(2 * M_PI / 1000, 0);
  checkNear(control.camera().position, before.position, 1e-11);
  control.orbit(0.7, -0.4);
  control.orbit(-0.7, 0.4);
  checkNear(control.camera().position, before.position, 1e-11);
}

TEST_CASE("orbit and look stop short of the poles, of whatever up") {
  for (Vec3d up : {Vec3d(0, 1, 0), Vec3d(0, 0, 7), Vec3d(1, -2, 0.5)}) {
    CameraDesc camera = cameraAt({3, 2, 1});
    camera.up = up;
    for (double turn : {0.1, 1.0, 1e9}) {
      CameraControl orbit = controlOf(camera), look = controlOf(camera);
      for (int i = 0; i < 100; ++i) orbit.orbit(0.1, turn), look.look(0.1, -turn);
      for (const CameraDesc& c : {orbit.camera(), look.camera()}) {
        double const angle = std::acos(std::clamp(-glm::dot(forward(c), glm::normalize(up)), -1.0, 1.0));
        CHECK(angle == doctest::Approx(1e-3).epsilon(1e-3));
        checkUsable(c);
      }
      orbit.orbit(0, -0.5);  // and away again
      CHECK(glm::dot(forward(orbit.camera()), glm::normalize(up)) == doctest::Approx(-std::cos(0.501)));
    }
  }
}

TEST_CASE("dolly comes near the target and never reaches it") {
  for (double size : sizes) {
    CAPTURE(size);
    CameraControl control = sized(size);
    CameraDesc const before = control.camera();
    control.dolly(0.5);
    CHECK(distance(control.camera()) == doctest::Approx(distance(before) * std::exp(-0.5)));
    for (int i = 0; i < 200; ++i) control.dolly(1);
    control.dolly(1e300);
    CHECK(distance(control.camera()) > 0);
    checkNear(forward(control.camera()), forward(before), 1e-6);
    checkUsable(control.camera());
    for (int i = 0; i < 200; ++i) control.dolly(-1);
    control.dolly(-1e300);
    checkNear(forward(control.camera()), forward(before), 1e-6);
    CHECK(distance(control.camera()) > 0.9 * maxCoordinate);
    checkUsable(control.camera());
  }
}

TEST_CASE("pan moves the picture by exactly its share") {
  TestRandom random(1);
  for (double size : sizes)
    for (double fov : {1.0, 45.0, 150.0}) {
      CameraControl control = sized(size);
      control.setFov(fov);
      control.orbit(random.between(-3, 3), random.between(-1, 1));
      CameraDesc const before = control.camera();
      control.pan(0.25, -0.125);
      const CameraDesc& after = control.camera();
      Vec3d const now = project(after, before.target, 1);
      CHECK(now.x == doctest::Approx(0.25));
      CHECK(now.y == doctest::Approx(0.375));
      CHECK(distance(after) == doctest::Approx(distance(before)));
      checkNear(forward(after), forward(before), 1e-9);
    }
}

TEST_CASE("look turns around the camera's place") {
  for (double size : sizes) {
    CameraControl control = sized(size);
    CameraDesc const before = control.camera();
    control.look(0.2, 0.1);
    const CameraDesc& after = control.camera();
    CHECK(after.position == before.position);
    CHECK(distance(after) == doctest::Approx(distance(before)).epsilon(1e-12));
    CHECK(glm::dot(forward(after), right(before)) > 0);
    CHECK(std::asin(forward(after).y) - std::asin(forward(before).y) == doctest::Approx(0.1));
  }
}

TEST_CASE("fly crosses the scene in five seconds") {
  for (double size : sizes) {
    CameraControl control = sized(size);
    CameraDesc const before = control.camera();
    control.fly({0, 0, 1}, 2.5);
    double const diagonal = 2 * size * std::sqrt(3.0);
    checkNear(control.camera().position - before.position, forward(before) * (diagonal / 2), 1e-12 * size);
    checkNear(control.camera().target - before.target, forward(before) * (diagonal / 2), 1e-12 * size);
    control.reset();
    control.speed = 3;
    control.fly({1e9, 0, 0}, 1);  // no faster than 1
    checkNear(control.camera().position - before.position, right(before) * (diagonal * 0.6), 1e-12 * size);
  }
}

TEST_CASE("frame shows all of the bounds, and not much more") {
  for (double size : sizes)
    for (double fov : {0.5, 20.0, 60.0, 120.0, 179.9})
      for (double aspect : {0.1, 1.0, 16.0 / 9, 20.0})
        for (Vec3d shape : {Vec3d(1, 1, 1), Vec3d(10, 0.1, 1), Vec3d(1, 0, 2), Vec3d(0, 3, 0)}) {
          CAPTURE(size);
          CAPTURE(fov);
          CAPTURE(aspect);
          CAPTURE(shape.x);
          Bounds const bounds{Vec3d(2, -1, 0.5) * size - shape * (size / 20),
                              Vec3d(2, -1, 0.5) * size + shape * (size / 20)};
          CameraControl control = sized(size);
          control.setFov(fov);
          Vec3d const direction = forward(control.camera());
          control.frame(bounds, aspect);
          const CameraDesc& c = control.camera();
          checkNear(forward(c), direction, 1e-9);
          checkNear(c.target, (bounds.min + bounds.max) / 2.0, 1e-12 * size);
          double reach = 0;
          for (int i = 0; i < 8; ++i) {
            Vec3d const corner(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                               i & 4 ? bounds.max.z : bounds.min.z);
            Vec3d const p = project(c, corner, aspect);
            CHECK(p.z > 0);
            reach = std::max({reach, std::abs(p.x - 0.5) * 2, std::abs(p.y - 0.5) * 2});
          }
          Vec3d const place = glm::abs(c.position);
          bool const atLimit = std::max({place.x, place.y, place.z}) > 0.999 * maxCoordinate;
          CHECK((reach <= 1 || atLimit));
          CHECK(atLimit <= (size > 1e11 && fov < 1));
          if (fov <= 60 && aspect <= 2) CHECK(reach > 0.7);
          checkUsable(c);
        }
}

TEST_CASE("frame takes bounds of no size and ignores those of none") {
  CameraControl control = sized(1);
  CameraDesc const before = control.camera();
  for (const Bounds& bounds : {Bounds{}, cube(notANumber), cube(infinite)}) {
    control.frame(bounds, 1);
    CHECK(control.camera() == before);
  }
  for (double aspect : {0.0, -1.0, notANumber, infinite}) {
    control.frame(cube(1), aspect);
    CHECK(control.camera() == before);
  }
  control.frame(cube(0, {1, 2, 3}), 1);
  CHECK(control.camera().target == Vec3d(1, 2, 3));
  CHECK(distance(control.camera()) == doctest::Approx(distance(before)));
}

TEST_CASE("directionThrough is the direction of the renderer's rays") {
  TestRandom random(2);
  for (double size : sizes)
    for (int i = 0; i < 20; ++i) {
      CameraControl control = sized(size);
      control.setFov(random.between(1, 170));
      control.orbit(random.between(-3, 3), random.between(-1, 1));
      int const width = 1 + int(random.below(2000)), height = 1 + int(random.below(2000));
      cpu::CameraView const renderer = cpu::makeCamera(control.camera(), width, height);
      double const x = random.unit(), y = random.unit();
      cpu::Ray const ray = renderer.generate(float(x * width), float(y * height));
      checkNear(control.directionThrough(x, y, double(width) / height), Vec3d(ray.direction), 2e-6);
    }
}

TEST_CASE("reset returns to home and keeps the saved views") {
  CameraControl control = sized(1);
  CameraDesc const home = control.camera();
  control.views.push_back({"side", cameraAt({9, 0, 0})});
  control.orbit(1, 0.1), control.setFov(10), control.setAperture(0.1);
  control.reset();
  CHECK(control.camera() == home);
  control.setHome(cameraAt({0, 0, 2}), Bounds{});
  CHECK(control.views.size() == 1);
}

TEST_CASE("the camera's JSON goes into a scene file and comes back bit for bit") {
  TestRandom random(4);
  TemporaryFolder folder;
  for (double size : sizes) {
    CameraControl control = sized(size);
    control.orbit(random.unit(), random.unit()), control.setFov(33.3), control.setAperture(size / 30);
    control.setFocusDistance(size / 7);
    std::string const text =
        R"({"camera": )" + cameraJson(control.camera()) +
        R"(, "materials": {"w": {"type": "diffuse"}}, "shapes": [{"type": "box", "material": "w"}]})";
    CHECK(loadScene(writeFile(folder, "scene.json", text)).camera == control.camera());
  }
  CHECK(cameraJson(cameraAt({0.1, 2, -3})) ==
        "{\n  \"position\": [0.1, 2.0, -3.0],\n  \"target\": [0.0, 0.0, 0.0],\n  \"up\": [0.0, 1.0, 0.0],\n"
        "  \"fov\": 45.0,\n  \"aperture\": 0.0,\n  \"focus\": 0.0\n}");
}
