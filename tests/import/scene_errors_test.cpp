// What the JSON loader says of bad scenes: file, place, what was expected.

#include "tests/scenes/bad_scenes.h"

using namespace ropelight;
using namespace ropelight::bad;

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
