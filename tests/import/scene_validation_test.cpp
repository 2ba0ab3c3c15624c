// Scenes that read well and still cannot be used.

#include <fmt/format.h>

#include <limits>

#include "tests/scenes/bad_scenes.h"

using namespace ropelight;
using namespace ropelight::bad;

TEST_CASE("empty scenes are refused") {
  Parts parts;
  parts.shapes = "[]";
  CHECK(messageOfText(parts.text()) == "s.json: /shapes: the scene is empty; expected at least one shape");
}

TEST_CASE("cameras without a direction are refused") {
  CHECK(ofCamera(R"({"position": [1, 2, 3], "target": [1, 2, 3]})") ==
        "s.json: /camera/target: target and position coincide; move one of them");
  CHECK(ofCamera(R"({"position": [0, 0, 0], "target": [0, 0, 0]})") ==
        "s.json: /camera/target: target and position coincide; move one of them");
  CHECK(ofCamera(R"({"position": [0, 0, 5], "target": [0, 0, 0], "up": [0, 0, 0]})") ==
        "s.json: /camera/up: expected a direction other than [0, 0, 0]");
  for (const char* up : {"[0, 0, 1]", "[0, 0, -7]", "[0, 1e-9, 1]"})
    CHECK(ofCamera(std::string(R"({"position": [0, 0, 5], "target": [0, 0, 0], "up": )") + up + "}") ==
          "s.json: /camera/up: up is parallel to the view direction; choose another up");
}

TEST_CASE("ellipsoids that single precision cannot hold are refused") {
  auto const sphere = [](const char* thin) {
    return ofShape(fmt::format(
        R"({{"type": "sphere", "material": "white", "radius": 2, "transform": [{{"rotate": {{"axis": [1, 2, 3], "degrees": 40}}}}, {{"scale": [1, 1, {}]}}]}})",
        thin));
  };
  CHECK(sphere("1e-4") == "no error");
  CHECK(contains(sphere("0.99e-4"),
                 "s.json: /shapes/0: the ellipsoid is 1.01e+04 times as long as thin, and beyond 10000"));
}

TEST_CASE("singular transforms are refused") {
  std::string const flat = "s.json: /shapes/0: the shape is flattened";
  CHECK(contains(ofTransform(R"({"scale": 0})"), flat));
  CHECK(contains(ofTransform(R"({"scale": [1, 0, 1]})"), flat));
  CHECK(contains(ofTransform(R"({"scale": [1, 1e-9, 1]})"), flat));
  CHECK(contains(ofTransform(R"({"matrix": [1, 1, 1, 0, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1]})"), flat));
  CHECK(contains(ofShape(R"({"type": "quad", "material": "white", "edge1": [1, 2, 3], "edge2": [2, 4, 6]})"), flat));
  CHECK(contains(ofShape(R"({"type": "quad", "material": "white", "edge1": [0, 0, 0]})"), flat));
  CHECK(ofTransform(R"({"scale": [1, 0.001, 1]})") == "no error");
}

TEST_CASE("transforms that make no sense are refused") {
  CHECK(ofTransform(R"({"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1]})") ==
        "s.json: /shapes/0/transform/0/matrix: expected 0, 0, 0, 1 as the last row: transforms are affine");
  CHECK(ofTransform(R"({"rotate": {"axis": [0, 0, 0], "degrees": 1}})") ==
        "s.json: /shapes/0/transform/0/rotate/axis: expected an axis other than [0, 0, 0], found an array of 3");
  CHECK(ofTransform("{}") ==
        "s.json: /shapes/0/transform/0: expected exactly one of translate, rotate, scale and matrix");
  CHECK(ofTransform(R"({"scale": 1, "translate": [0, 0, 0]})") ==
        "s.json: /shapes/0/transform/0: expected exactly one of translate, rotate, scale and matrix");
  CHECK(ofShape(R"({"type": "box", "material": "white", "min": [0, 0, 0], "max": [1, 0, 1]})") ==
        "s.json: /shapes/0: expected min < max, found 0 and 0 on axis y");
}

TEST_CASE("shapes beyond the reach of single precision are refused") {
  CHECK(ofTransform(R"({"scale": 1e14}, {"scale": 1e3})") ==
        "s.json: /shapes/0: the shape reaches beyond 1e14 scene units; scale the scene down");
  std::string const huge = R"({"scale": 1e14}, )";
  CHECK(
      contains(ofTransform(huge + huge + huge + huge + R"({"scale": 1e14})"), "s.json: /shapes/0: the shape reaches"));
  CHECK(ofTransform(R"({"scale": 1e-8}, {"scale": 1e-8})") ==
        "s.json: /shapes/0: the shape is smaller than 1e-15 scene units; scale the scene up");
  CHECK(contains(ofTransform(R"({"scale": 1e13})"), "units across, and single precision holds scenes of 1e-09 to"));
  CHECK(contains(ofTransform(R"({"scale": 1e-11})"), "s.json: /shapes: the scene is"));
}

TEST_CASE("a mesh that emits is refused") {
  TemporaryFolder folder;
  writeFile(folder, "x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Parts parts;
  parts.shapes = R"([{"type": "mesh", "material": "white", "file": "x.obj", "emission": {"radiance": 1}}])";
  CHECK(messageOf(folder, writeFile(folder, "s.json", parts.text())) ==
        "s.json: /shapes/0/emission: a mesh cannot emit light; give the emission to a sphere, box or quad");
}

TEST_CASE("what a loader in code gets wrong is refused too") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  auto message = [](auto spoil) -> std::string {
    Scene scene;
    scene.file = "code";
    scene.materials = {{"white", DiffuseParams{}}};
    scene.meshes = {{"mesh", {Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)}, {{0, 1, 2}}}};
    scene.shapes = {ShapeDesc{}};
    spoil(scene);
    try {
      validateScene(scene);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  CHECK(message([](Scene&) {}) == "no error");
  CHECK(message([](Scene& s) { s.camera.position.x = nan; }) ==
        "code: /camera/position: expected finite coordinates of at most 1e14");
  CHECK(message([](Scene& s) { s.camera.target.y = nan; }) ==
        "code: /camera/target: expected finite coordinates of at most 1e14");
  CHECK(message([](Scene& s) { s.camera.up.z = nan; }) ==
        "code: /camera/up: expected finite coordinates of at most 1e14");
  CHECK(message([](Scene& s) { s.camera.verticalFov = nan; }) ==
        "code: /camera/fov: expected degrees in [0.001, 179.9]");
  CHECK(message([](Scene& s) { s.camera.apertureRadius = nan; }) ==
        "code: /camera/aperture: expected a radius of 0 or more");
  CHECK(message([](Scene& s) { s.camera.focusDistance = nan; }) ==
        "code: /camera/focus: expected a distance of 0 or more");
  CHECK(contains(message([](Scene& s) { s.film.width = 0; }), "code: /film: 0 x 512 pixels"));
  CHECK(
      contains(message([](Scene& s) { s.shapes[0].toWorld[1][1] = nan; }), "code: /shapes/0: the shape is flattened"));
  CHECK(contains(message([](Scene& s) { s.shapes[0].toWorld[3][1] = nan; }),
                 "code: /shapes/0: the shape reaches beyond"));
  CHECK(message([](Scene& s) { s.shapes[0].material = 1; }) == "code: /shapes/0: the shape has no material");
  CHECK(message([](Scene& s) { s.shapes[0].kind = ShapeKind::mesh; }) == "code: /shapes/0: the shape has no mesh");
  CHECK(message([](Scene& s) {
          s.shapes[0].emission = Emission{Rgb(float(nan)), Side::out};
        }) == "code: /shapes/0/emission/radiance: expected finite values in [0, 1e15] W/(sr m^2)");
  CHECK(message([](Scene& s) { s.meshes[0].triangles[0].y = 3; }) == "mesh: triangle 1 names vertex 4 of 3");
  CHECK(message([](Scene& s) { s.meshes[0].positions[2].y = nan; }) ==
        "mesh: vertex 3: expected finite coordinates of at most 1e14");
  CHECK(message([](Scene& s) { s.meshes[0].triangles.clear(); }) == "mesh: the mesh has no triangles");
}
