// What the JSON loader makes of good scenes.

#include <doctest/doctest.h>

#include <limits>

#include "render/import/load.h"
#include "render/scene/transform.h"
#include "render/text/suggest.h"
#include "tests/support/scene_files.h"

using namespace ropelight;

namespace {

Scene loadText(const std::string& text) {
  TemporaryFolder folder;
  return loadScene(writeFile(folder, "scene.json", text));
}

/// A scene of the given shapes, with materials white and glass.
Scene loadShapes(const std::string& shapes) {
  return loadText(R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]},
                      "materials": {"white": {"type": "diffuse"}, "glass": {"type": "dielectric"}},
                      "shapes": [)" +
                  shapes + "]}");
}

void checkNear(Vec3d a, Vec3d b, double tolerance = 1e-12) {
  for (int i = 0; i < 3; ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(tolerance).scale(1));
}

Vec3d at(const ShapeDesc& shape, Vec3d local) { return transformPoint(shape.toWorld, local); }

const MaterialDesc& materialOf(const Scene& scene, const ShapeDesc& shape) {
  return scene.materials.at(shape.material).desc;
}

}  // namespace

TEST_CASE("every field of a scene is read") {
  Scene const scene = loadText(R"({
    "name": "all", "description": "of it",
    "camera": {"position": [1, 2, 3], "target": [4, 5, 7], "up": [0, 0, 1], "fov": 30, "aperture": 0.25, "focus": 6},
    "film": {"width": 640, "height": 480.0},
    "materials": {
      "a": {"type": "diffuse", "albedo": [0.1, 0.2, 0.3]},
      "b": {"type": "mirror", "reflectance": 0.5},
      "c": {"type": "dielectric", "ior": 1.33, "reflectance": [1, 0, 1], "transmittance": 0.25}},
    "shapes": [{"type": "sphere", "name": "ball", "center": [1, 2, 3], "radius": 2, "material": "c",
                "emission": {"radiance": [1, 2, 3], "side": "both"}}]})");
  CHECK(scene.name == "all");
  CHECK(scene.camera.position == Vec3d(1, 2, 3));
  CHECK(scene.camera.target == Vec3d(4, 5, 7));
  CHECK(scene.camera.up == Vec3d(0, 0, 1));
  CHECK(scene.camera.verticalFov == 30);
  CHECK(scene.camera.apertureRadius == 0.25);
  CHECK(scene.camera.focusDistance == 6);
  CHECK(scene.film.width == 640);
  CHECK(scene.film.height == 480);
  REQUIRE(scene.materials.size() == 3);
  CHECK(std::get<DiffuseParams>(scene.materials[0].desc).albedo == Rgb(0.1f, 0.2f, 0.3f));
  CHECK(std::get<MirrorParams>(scene.materials[1].desc).reflectance == Rgb(0.5f));
  auto const glass = std::get<DielectricParams>(scene.materials[2].desc);
  CHECK(glass.ior == 1.33f);
  CHECK(glass.reflectance == Rgb(1, 0, 1));
  CHECK(glass.transmittance == Rgb(0.25f));
  REQUIRE(scene.shapes.size() == 1);
  CHECK(scene.shapes[0].name == "ball");
  CHECK(scene.shapes[0].material == 2);
  REQUIRE(scene.shapes[0].emission);
  CHECK(scene.shapes[0].emission->radiance == Rgb(1, 2, 3));
  CHECK(scene.shapes[0].emission->side == Side::both);
  checkNear(at(scene.shapes[0], {0, 0, 1}), {1, 2, 5});
}

TEST_CASE("what is left out takes the documented defaults") {
  Scene const scene = loadShapes(R"({"type": "sphere", "material": "white"}, {"type": "box", "material": "white"},
                                    {"type": "quad", "material": "glass", "emission": {"radiance": 2}})");
  CHECK(scene.name == "scene");
  CHECK(scene.camera.up == Vec3d(0, 1, 0));
  CHECK(scene.camera.verticalFov == 45);
  CHECK(scene.camera.apertureRadius == 0);
  CHECK(scene.camera.focusDistance == 0);
  CHECK(scene.film.width == 512);
  CHECK(scene.film.height == 512);
  CHECK(std::get<DiffuseParams>(materialOf(scene, scene.shapes[0])).albedo == Rgb(0.8f));
  CHECK(std::get<DielectricParams>(materialOf(scene, scene.shapes[2])).ior == 1.5f);
  for (int i = 0; i < 2; ++i) CHECK(scene.shapes[i].toWorld == Mat4d(1.0));
  checkNear(at(scene.shapes[2], {1, 1, 0}), {1, 1, 0});
  CHECK(scene.shapes[2].emission->side == Side::out);
}

TEST_CASE("shapes stand where their fields say") {
  Scene const scene = loadShapes(R"({"type": "box", "min": [1, 2, 3], "max": [3, 6, 4], "material": "white"},
    {"type": "quad", "corner": [1, 1, 1], "edge1": [0, 2, 0], "edge2": [0, 0, 3], "material": "white"})");
  checkNear(at(scene.shapes[0], {-1, -1, -1}), {1, 2, 3});
  checkNear(at(scene.shapes[0], {1, 1, 1}), {3, 6, 4});
  checkNear(at(scene.shapes[1], {0, 0, 0}), {1, 1, 1});
  checkNear(at(scene.shapes[1], {1, 0, 0}), {1, 3, 1});
  checkNear(at(scene.shapes[1], {0, 1, 0}), {1, 1, 4});
  checkNear(glm::normalize(transformVector(scene.shapes[1].toWorld, {0, 0, 1})), {1, 0, 0});
}

TEST_CASE("transforms apply in order, the first first") {
  Scene const scene = loadShapes(R"({"type": "sphere", "material": "white", "transform": [
    {"scale": [1, 2, 3]}, {"rotate": {"axis": [0, 0, 2], "degrees": 90}}, {"translate": [10, 0, 0]}]},
    {"type": "sphere", "material": "white", "transform": [
    {"translate": [10, 0, 0]}, {"scale": 2}, {"matrix": [0, -1, 0, 5,  1, 0, 0, 6,  0, 0, 1, 7,  0, 0, 0, 1]}]})");
  checkNear(at(scene.shapes[0], {1, 0, 0}), {10, 1, 0});
  checkNear(at(scene.shapes[0], {0, 1, 0}), {8, 0, 0});
  checkNear(at(scene.shapes[0], {0, 0, 1}), {10, 0, 3});
  checkNear(at(scene.shapes[1], {0, 0, 0}), {5, 26, 7});
}

TEST_CASE("a shape's own placement comes before its transform") {
  Scene const scene = loadShapes(R"({"type": "sphere", "center": [1, 0, 0], "radius": 0.5, "material": "white",
                                     "transform": [{"scale": 2}]})");
  checkNear(at(scene.shapes[0], {0, 0, 0}), {2, 0, 0});
  checkNear(at(scene.shapes[0], {1, 0, 0}), {3, 0, 0});
}

TEST_CASE("a mirrored quad's normal is the cross product of its mirrored edges") {
  Scene const scene = loadShapes(R"({"type": "quad", "material": "white", "transform": [{"scale": [-1, 1, 1]}]})");
  Mat4d const m = scene.shapes[0].toWorld;
  Vec3d const normal = glm::cross(Vec3d(m[0]), Vec3d(m[1]));
  checkNear(glm::normalize(normal), {0, 0, -1});
  CHECK(glm::dot(normal, Vec3d(m[2])) > 0);
  CHECK(glm::determinant(m) > 0);
}

TEST_CASE("tiny and huge uniform scales are accepted") {
  for (const char* scale : {"1e-8", "1e-9", "1e11", "-3"})
    CHECK_NOTHROW(
        loadShapes(std::string(R"({"type": "box", "material": "white", "transform": [{"scale": )") + scale + "}]}"));
}

TEST_CASE("black emission is none") {
  Scene const scene = loadShapes(R"({"type": "sphere", "material": "white", "emission": {"radiance": 0}})");
  CHECK_FALSE(scene.shapes[0].emission);
}

TEST_CASE("emission takes each side") {
  Scene const scene = loadShapes(R"({"type": "sphere", "material": "white", "emission": {"radiance": 1, "side": "in"}},
                                    {"type": "box", "material": "white", "emission": {"radiance": 1, "side": "out"}})");
  CHECK(scene.shapes[0].emission->side == Side::in);
  CHECK(scene.shapes[1].emission->side == Side::out);
}

TEST_CASE("a mesh file is found beside its scene and read once") {
  TemporaryFolder folder;
  writeFile(folder, "meshes/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::string const path = writeFile(folder, "scene.json", R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]},
    "materials": {"white": {"type": "diffuse"}}, "shapes": [
    {"type": "mesh", "file": "meshes/tri.obj", "material": "white"},
    {"type": "mesh", "file": "./meshes/../meshes/tri.obj", "material": "white", "transform": [{"scale": 2}]}]})");
  Scene const scene = loadScene(path);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].triangles.size() == 1);
  CHECK(scene.shapes[0].mesh == 0);
  CHECK(scene.shapes[1].mesh == 0);
}

TEST_CASE("the condition number sees shape, not size") {
  CHECK(conditionNumber(Mat3d(1.0)) == doctest::Approx(1));
  CHECK(conditionNumber(Mat3d(1e-200)) == doctest::Approx(1));
  CHECK(conditionNumber(Mat3d(1e200)) == doctest::Approx(1));
  CHECK(conditionNumber(Mat3d(rotation({1, 2, 3}, 77))) == doctest::Approx(1));
  CHECK(conditionNumber(Mat3d(scaling({1, 1, 1e-9}))) > 1e8);
  CHECK(conditionNumber(Mat3d(scaling({1, 1, 0}))) == std::numeric_limits<double>::infinity());
  CHECK(conditionNumber(Mat3d(std::nan(""))) == std::numeric_limits<double>::infinity());
}

TEST_CASE("rotations keep lengths and turn by the right hand") {
  checkNear(transformVector(rotation({0, 1, 0}, 90), {0, 0, 1}), {1, 0, 0});
  checkNear(transformVector(rotation({1, 1, 1}, 120), {1, 0, 0}), {0, 1, 0});
  checkNear(transformVector(rotation({0, 0, 1e-12}, -450), {1, 0, 0}), {0, -1, 0});
}

TEST_CASE("suggestions name what is near and keep silent otherwise") {
  std::vector<std::string> const known = {"albedo", "reflectance", "type"};
  CHECK(suggestion("albdeo", known) == "; did you mean \"albedo\"?");
  CHECK(suggestion("typ", known) == "; did you mean \"type\"?");
  CHECK(suggestion("roughness", known).empty());
  CHECK(suggestion(std::string(100000, 'a'), known).empty());
  CHECK(joinNames({}) == "none");
}
