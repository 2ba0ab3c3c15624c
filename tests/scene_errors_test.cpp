// What the loaders say of bad scenes: file, place, what was expected.

#include <doctest/doctest.h>

#include <limits>

#include "render/core/error.h"
#include "render/scene/load.h"
#include "tests/scene_files.h"

using namespace ropelight;
namespace fs = std::filesystem;

namespace {

/// The message of a failed load, without the path of the folder; the exit code is checked on the way.
std::string messageOf(const TemporaryFolder& folder, const fs::path& path) {
  try {
    loadScene(path);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::badInput);
    std::string text = error.what();
    std::string const prefix = folder.path().string() + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
    return text;
  }
  return "no error";
}

std::string messageOfText(const std::string& text, const std::string& name = "s.json") {
  TemporaryFolder folder;
  return messageOf(folder, writeFile(folder, name, text));
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A good scene, part by part, so that a test can spoil one.
struct Parts {
  std::string camera = R"({"position": [0, 0, 5], "target": [0, 0, 0]})";
  std::string materials = R"({"white": {"type": "diffuse"}})";
  std::string shapes = R"([{"type": "sphere", "material": "white"}])";
  std::string more;

  std::string text() const {
    return "{\"camera\": " + camera + ", \"materials\": " + materials + ", \"shapes\": " + shapes + more + "}";
  }
};

std::string ofCamera(const std::string& camera) {
  Parts parts;
  parts.camera = camera;
  return messageOfText(parts.text());
}

std::string ofMaterial(const std::string& material) {
  Parts parts;
  parts.materials = "{\"white\": {\"type\": \"diffuse\"}, \"m\": " + material + "}";
  return messageOfText(parts.text());
}

std::string ofShape(const std::string& shape) {
  Parts parts;
  parts.shapes = "[" + shape + "]";
  return messageOfText(parts.text());
}

std::string ofSphere(const std::string& members) {
  return ofShape(R"({"type": "sphere", "material": "white", )" + members + "}");
}

std::string ofTransform(const std::string& operations) { return ofSphere("\"transform\": [" + operations + "]"); }

std::string ofMore(const std::string& more) {
  Parts parts;
  parts.more = ", " + more;
  return messageOfText(parts.text());
}

std::string ofObj(const std::string& text) { return messageOfText(text, "m.obj"); }

}  // namespace

TEST_CASE("the scene that the other tests spoil is good") { CHECK(messageOfText(Parts().text()) == "no error"); }

TEST_CASE("files that cannot be read are named with the reason") {
  TemporaryFolder folder;
  CHECK(messageOf(folder, folder / "none.json") ==
        "none.json: cannot be read: No such file or directory; check the path");
  CHECK(messageOf(folder, folder / "none.obj") ==
        "none.obj: cannot be read: No such file or directory; check the path");
  fs::create_directory(folder / "d.json");
  CHECK(messageOf(folder, folder / "d.json") == "d.json: cannot be read: it is a directory; check the path");
  CHECK(messageOf(folder, folder / "s.fbx") == "s.fbx: \".fbx\" is no known scene format; expected one of .json, .obj");
  CHECK(messageOf(folder, folder / "s") == "s: \"\" is no known scene format; expected one of .json, .obj");
}

TEST_CASE("bad syntax is named with line and column") {
  CHECK(
      contains(messageOfText("{\n  \"name\": nope\n}"), "s.json: line 2, column 12: syntax error while parsing value"));
  CHECK(contains(messageOfText(""), "s.json: line 1, column 1: syntax error"));
  CHECK(contains(messageOfText("{\"a\": 1,}"), "s.json: line 1, column 9: syntax error"));
  CHECK(contains(messageOfText("{\"a\": NaN}"), "s.json: line 1, column 7: syntax error"));
  CHECK(contains(messageOfText("{} x"), "s.json: line 1, column 4: syntax error"));
  CHECK(contains(messageOfText("{\"name\": \"\xff\"}"), "s.json: line 1, column 11: syntax error"));
}

TEST_CASE("nesting without end is an error and no crash") {
  CHECK(contains(messageOfText(std::string(1000000, '[')), "s.json: line 1, column 1000001: syntax error"));
  std::string const deep = std::string(100000, '[') + std::string(100000, ']');
  CHECK(ofMore("\"name\": " + deep) == "s.json: /name: expected a string, found an array of 1");
}

TEST_CASE("a key given twice is refused") {
  CHECK(ofMore(R"("camera": 1)") == "s.json: /camera: the key occurs twice; remove one");
  CHECK(ofSphere(R"("radius": 1, "radius": 2)") == "s.json: /shapes/0/radius: the key occurs twice; remove one");
  CHECK(ofMaterial(R"({"type": "diffuse"}, "a/b": {"type": "mirror"}, "a/b": 1)") ==
        "s.json: /materials/a~1b: the key occurs twice; remove one");
}

TEST_CASE("numbers beyond double precision are refused") {
  CHECK(ofCamera(R"({"position": [0, 1e999, 5], "target": [0, 0, 0]})") ==
        "s.json: /camera/position/1: the number is too large for double precision");
  CHECK(ofSphere(R"("radius": -1e400)") == "s.json: /shapes/0/radius: the number is too large for double precision");
}

TEST_CASE("unknown keys are refused with those known and what was meant") {
  CHECK(ofCamera(R"({"position": [0, 0, 5], "target": [0, 0, 0], "fovy": 3})") ==
        "s.json: /camera/fovy: unknown key; did you mean \"fov\"?; known keys: position, target, up, fov, aperture, "
        "focus");
  CHECK(ofMore(R"("textures": {})") ==
        "s.json: /textures: unknown key; known keys: name, description, camera, film, materials, shapes");
  CHECK(ofMore(R"("film": {"with": 1})") ==
        "s.json: /film/with: unknown key; did you mean \"width\"?; known keys: width, height");
  CHECK(ofMaterial(R"({"type": "diffuse", "albdeo": 1})") ==
        "s.json: /materials/m/albdeo: unknown key; did you mean \"albedo\"?; known keys: type, albedo");
  CHECK(ofSphere(R"("edge1": [1, 0, 0])") ==
        "s.json: /shapes/0/edge1: unknown key; known keys: type, name, material, transform, emission, center, radius");
  CHECK(ofSphere(R"("emission": {"radience": 1})") ==
        "s.json: /shapes/0/emission/radience: unknown key; did you mean \"radiance\"?; known keys: radiance, side");
  CHECK(ofTransform(R"({"shear": 1})") ==
        "s.json: /shapes/0/transform/0/shear: unknown key; known keys: translate, rotate, scale, matrix");
  CHECK(ofTransform(R"({"rotate": {"axis": [1, 0, 0], "degrees": 1, "radians": 1}})") ==
        "s.json: /shapes/0/transform/0/rotate/radians: unknown key; known keys: axis, degrees");
}

TEST_CASE("missing keys are named") {
  CHECK(messageOfText("{}") == "s.json: top level: missing key \"camera\"");
  CHECK(messageOfText(R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]}})") ==
        "s.json: top level: missing key \"materials\"");
  CHECK(messageOfText(R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]}, "materials": {}})") ==
        "s.json: top level: missing key \"shapes\"");
  CHECK(ofCamera(R"({"target": [0, 0, 0]})") == "s.json: /camera: missing key \"position\"");
  CHECK(ofCamera(R"({"position": [0, 0, 0]})") == "s.json: /camera: missing key \"target\"");
  CHECK(ofMaterial("{}") == "s.json: /materials/m: missing key \"type\"");
  CHECK(ofShape("{}") == "s.json: /shapes/0: missing key \"type\"");
  CHECK(ofShape(R"({"type": "sphere"})") == "s.json: /shapes/0: missing key \"material\"");
  CHECK(ofShape(R"({"type": "mesh", "material": "white"})") == "s.json: /shapes/0: missing key \"file\"");
  CHECK(ofSphere(R"("emission": {})") == "s.json: /shapes/0/emission: missing key \"radiance\"");
  CHECK(ofTransform(R"({"rotate": {"degrees": 1}})") == "s.json: /shapes/0/transform/0/rotate: missing key \"axis\"");
  CHECK(ofTransform(R"({"rotate": {"axis": [0, 0, 1]}})") ==
        "s.json: /shapes/0/transform/0/rotate: missing key \"degrees\"");
}

TEST_CASE("wrong types are named with what was expected and found") {
  CHECK(messageOfText("[]") == "s.json: top level: expected an object, found an array of 0");
  CHECK(messageOfText("\"" + std::string(100, 'x') + "\"") ==
        "s.json: top level: expected an object, found \"" + std::string(39, 'x') + "…");
  CHECK(ofMore(R"("name": 1)") == "s.json: /name: expected a string, found 1");
  CHECK(ofMore(R"("description": [])") == "s.json: /description: expected a string, found an array of 0");
  CHECK(ofCamera("null") == "s.json: /camera: expected an object, found null");
  CHECK(ofCamera(R"({"position": 1, "target": [0, 0, 0]})") ==
        "s.json: /camera/position: expected three numbers [x, y, z], found 1");
  CHECK(ofCamera(R"({"position": [1, 2], "target": [0, 0, 0]})") ==
        "s.json: /camera/position: expected three numbers [x, y, z], found an array of 2");
  CHECK(ofCamera(R"({"position": [1, 2, "3"], "target": [0, 0, 0]})") ==
        "s.json: /camera/position/2: expected a number in [-1e+14, 1e+14] scene units, found \"3\"");
  CHECK(ofMore(R"("film": 1)") == "s.json: /film: expected an object, found 1");
  CHECK(ofMore(R"("film": {"width": 1.5})") ==
        "s.json: /film/width: expected a whole number in [1, 65536] pixels, found 1.5");
  CHECK(ofMore(R"("film": {"width": "1"})") ==
        "s.json: /film/width: expected a whole number in [1, 65536] pixels, found \"1\"");
  CHECK(ofMaterial("[1, 2]") == "s.json: /materials/m: expected an object, found an array of 2");
  CHECK(ofMaterial(R"({"type": "diffuse", "albedo": "red"})") ==
        "s.json: /materials/m/albedo: expected a colour [r, g, b] or one number, found \"red\"");
  CHECK(ofMaterial(R"({"type": "diffuse", "albedo": [1, 1]})") ==
        "s.json: /materials/m/albedo: expected a colour [r, g, b] or one number, found an array of 2");
  CHECK(ofMaterial(R"({"type": "dielectric", "ior": [1, 1, 1]})") ==
        "s.json: /materials/m/ior: expected a number in [0.1, 10], found an array of 3");
  CHECK(ofShape("7") == "s.json: /shapes/0: expected an object, found 7");
  CHECK(ofSphere(R"("name": {})") == "s.json: /shapes/0/name: expected a string, found an object");
  CHECK(ofSphere(R"("emission": true)") == "s.json: /shapes/0/emission: expected an object, found true");
  CHECK(ofSphere(R"("transform": {})") == "s.json: /shapes/0/transform: expected an array, found an object");
  CHECK(ofTransform("1") == "s.json: /shapes/0/transform/0: expected an object, found 1");
  CHECK(ofTransform(R"({"matrix": [1, 2]})") ==
        "s.json: /shapes/0/transform/0/matrix: expected 16 numbers, row by row, found an array of 2");
  Parts parts;
  parts.shapes = "{}";
  CHECK(messageOfText(parts.text()) == "s.json: /shapes: expected an array, found an object");
  parts.materials = "[]";
  CHECK(messageOfText(parts.text()) == "s.json: /materials: expected an object, found an array of 0");
}

TEST_CASE("values out of range are named with the range") {
  for (const char* fov : {"0", "-1", "180"})
    CHECK(ofCamera(std::string(R"({"position": [0, 0, 5], "target": [0, 0, 0], "fov": )") + fov + "}") ==
          std::string("s.json: /camera/fov: expected a number in [0.001, 179.9] degrees, found ") + fov);
  CHECK(ofCamera(R"({"position": [0, 0, 5], "target": [0, 0, 0], "aperture": -0.1})") ==
        "s.json: /camera/aperture: expected a number in [0, 1e+14] scene units, found -0.1");
  CHECK(ofCamera(R"({"position": [0, 0, 5], "target": [0, 0, 0], "focus": -2})") ==
        "s.json: /camera/focus: expected a number in [0, 1e+14] scene units, found -2");
  CHECK(ofMore(R"("film": {"width": 0})") ==
        "s.json: /film/width: expected a whole number in [1, 65536] pixels, found 0");
  CHECK(ofMore(R"("film": {"height": 18446744073709551615})") ==
        "s.json: /film/height: expected a whole number in [1, 65536] pixels, found 18446744073709551615");
  CHECK(ofMore(R"("film": {"width": 65536, "height": 65536})") ==
        "s.json: /film: 65536 x 65536 pixels; expected edges in [1, 65536] and at most 2^28 pixels");
  CHECK(ofMaterial(R"({"type": "diffuse", "albedo": 1.01})") ==
        "s.json: /materials/m/albedo: expected a number in [0, 1], found 1.01");
  CHECK(ofMaterial(R"({"type": "mirror", "reflectance": [0, -0.5, 0]})") ==
        "s.json: /materials/m/reflectance/1: expected a number in [0, 1], found -0.5");
  CHECK(ofMaterial(R"({"type": "dielectric", "ior": 0})") ==
        "s.json: /materials/m/ior: expected a number in [0.1, 10], found 0");
  CHECK(ofSphere(R"("radius": 0)") ==
        "s.json: /shapes/0/radius: expected a number in [1e-15, 1e+14] scene units, found 0");
  CHECK(ofSphere(R"("emission": {"radiance": [1, 1, -1]})") ==
        "s.json: /shapes/0/emission/radiance/2: expected a number in [0, 1e+15] W/(sr m^2), found -1");
  CHECK(ofTransform(R"({"rotate": {"axis": [0, 0, 1], "degrees": 1e7}})") ==
        "s.json: /shapes/0/transform/0/rotate/degrees: expected a number in [-1e+06, 1e+06] degrees, found 10000000.0");
}

TEST_CASE("names that are not known are refused with those that are") {
  CHECK(ofMaterial(R"({"type": "difuse"})") ==
        "s.json: /materials/m/type: unknown material type \"difuse\"; did you mean \"diffuse\"?; known: diffuse, "
        "mirror, dielectric");
  CHECK(ofShape(R"({"type": "cone", "material": "white"})") ==
        "s.json: /shapes/0/type: unknown shape type \"cone\"; known: sphere, box, quad, mesh");
  CHECK(ofShape(R"({"type": "sphere", "material": "whit"})") ==
        "s.json: /shapes/0/material: unknown material \"whit\"; did you mean \"white\"?; known: white");
  CHECK(ofSphere(R"("emission": {"radiance": 1, "side": "inside"})") ==
        "s.json: /shapes/0/emission/side: unknown side \"inside\"; known: out, in, both");
  Parts parts;
  parts.materials = "{}";
  CHECK(messageOfText(parts.text()) == "s.json: /shapes/0/material: unknown material \"white\"; known: none");
}

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
}

TEST_CASE("a mesh that is missing is named with how to get it") {
  CHECK(ofShape(R"({"type": "mesh", "material": "white", "file": "no/such.obj"})") ==
        "no/such.obj: cannot be read: No such file or directory; s.json: /shapes/0/file names it, relative to the "
        "scene; check the path");
  CHECK(ofShape(R"({"type": "mesh", "material": "white", "file": "no.obj", "generator": "scripts/make.py"})") ==
        "no.obj: cannot be read: No such file or directory; s.json: /shapes/0/file names it, relative to the scene; "
        "run scripts/make.py to make it");
  CHECK(ofShape(R"({"type": "mesh", "material": "white", "file": "x.obj", "emission": {"radiance": 1}})") ==
        "s.json: /shapes/0/emission: a mesh cannot emit light; give the emission to a sphere, box or quad");
}

TEST_CASE("the bumpy scene says which script makes its mesh") {
  TemporaryFolder folder;
  std::string const text = fileBytes(fs::path(ROPELIGHT_ASSETS) / "bumpy.json");
  std::string const message = messageOf(folder, writeFile(folder, "bumpy.json", text));
  CHECK(contains(message, "generated/bumpy100k.obj: cannot be read: No such file"));
  CHECK(contains(message, "run scripts/make_bumpy_mesh.py to make it"));
}

TEST_CASE("bad meshes are refused with the line") {
  std::string const corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(ofObj("") == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  CHECK(ofObj(corners) == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  CHECK(ofObj(std::string("\x7f"
                          "ELF\0\xff\xfe\n\n\0",
                          10)) == "m.obj: the file holds no faces; expected a Wavefront OBJ mesh");
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "1.0abc", "x", "0x10"})
    CHECK(ofObj("v 0 0 0\r\n\r\nv 0 " + std::string(bad) + " 0\r\n" + corners) ==
          "m.obj: line 3: expected a finite coordinate, found \"" + std::string(bad) + "\"");
  CHECK(ofObj("# two\r# lines\rv 1 2") == "m.obj: line 3: a vertex needs three coordinates");
  CHECK(ofObj(corners + "f 1 2\n") == "m.obj: line 4: a face needs at least three vertices, this has 2");
  CHECK(ofObj(corners + "f 1 2 4\n") == "m.obj: line 4: a face names vertex 4, but 3 were read so far");
  CHECK(ofObj(corners + "\nf 0 1 2\n") == "m.obj: line 5: a face names vertex 0, but 3 were read so far");
  CHECK(ofObj(corners + "f -4 -1 -2\n") == "m.obj: line 4: a face names vertex -4, but 3 were read so far");
  CHECK(ofObj(corners + "f 1 2 2147483647") == "m.obj: line 4: a face names vertex 2147483647, but 3 were read so far");
  CHECK(contains(ofObj(corners + "f 1 2 4294967297"), "m.obj: line 4: "));
  CHECK(ofObj(corners + "f 1 2 x\n") ==
        "m.obj: line 4: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"x\"");
  CHECK(ofObj(corners + "f 1 2 \\\n3\n") ==
        "m.obj: line 4: expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"\\\"");
  CHECK(contains(ofObj(corners + "f 1/2/3/4 2 3\n"), "m.obj: line 4: "));
  CHECK(ofObj("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n") ==
        "m.obj: the mesh has no usable size: its vertices all coincide or lie too far apart");
  CHECK(contains(ofObj("v 1e30 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "m.obj: "));
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
