// What the loader says of meshes that it repaired, approximated or doubts; and `flip`.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "render/flatten/flatten.h"
#include "render/import/load.h"
#include "render/import/obj/obj.h"
#include "render/polygon/winding.h"
#include "tests/support/program.h"
#include "tests/support/rendering.h"
#include "tests/support/scene_files.h"

using namespace ropelight;

namespace {

using Notes = std::vector<std::string>;

/// What is said of an OBJ's text, without the file's name.
std::string noteOf(const std::string& text) {
  TemporaryFolder folder;
  return describe("m.obj", loadObj(writeFile(folder, "m.obj", text)).report);
}

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

/// A cube of edge 2 around the origin, its faces outwards, or inwards.
std::string cube(bool inwards, double offset = 0) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    auto at = [&](int bit) { return std::to_string((i & bit ? 1 : -1) + offset) + " "; };
    text += "v " + at(1) + at(2) + at(4) + "\n";
  }
  constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces) {
    text += "f";
    for (int k = 0; k < 4; ++k) text += " " + std::to_string(f[inwards ? 3 - k : k] + 1);
    text += "\n";
  }
  return text;
}

/// A scene with shapes of m.obj, with materials white and glass.
Scene sceneOf(const TemporaryFolder& folder, const std::string& mesh, const std::string& shapes) {
  writeFile(folder, "m.obj", mesh);
  return loadScene(writeFile(folder, "s.json",
                             R"({"camera": {"position": [0, 0, 5], "target": [0, 0, 0]},
                                 "materials": {"white": {"type": "diffuse"}, "glass": {"type": "dielectric"}},
                                 "shapes": [)" +
                                 shapes + "]}"));
}

std::string meshShape(const std::string& material, const std::string& more = "") {
  return R"({"type": "mesh", "file": "m.obj", "material": ")" + material + "\"" + more + "}";
}

/// Of the triangles of a scene whose shapes are closed.
double flatVolume(const FlatScene& flat) {
  double volume = 0;
  for (const FlatTriangle& t : flat.triangles) volume += glm::dot(t.a, glm::cross(t.b, t.c)) / 6;
  return volume;
}

}  // namespace

TEST_CASE("a mesh that is taken as it is has no note") {
  CHECK(noteOf(square + "f 1 2 3 4\n").empty());
  CHECK(noteOf(cube(false)).empty());
}

TEST_CASE("what was dropped or approximated is counted, a line a file") {
  CHECK(noteOf(square + "f 1 2 3 4\nf 1 2 2\nf 1 1 1 1\n") == "m.obj: 2 faces without an area were dropped");
  CHECK(noteOf(square + "v 9 9 9\nf 1 2 3 4\n") == "m.obj: 1 vertex belongs to no face");
  CHECK(noteOf(square + "v 0 0 1\nv 2 0 1\nf 1 2 3 4\nf 5 2 3 4\nf 6 2 3 4\nl 1 5 6\n") ==
        "m.obj: 2 of 3 polygons are not planar (by up to 14% of the size), 1 point, line, curve or surface was left "
        "out");
  CHECK(noteOf(square + "f 1 3 2 4\nf 1 2 3\n") == "m.obj: 1 of 1 polygon crosses itself");
  CHECK(noteOf(square + "v 1e-9 0 0\nf 1 2 3 4\nf 1 5 4\n") ==
        "m.obj: 1 triangle is too small or thin for single precision");
  CHECK(noteOf(square + "v 0.5 1e-9 0\nf 1 2 3 4\nf 1 2 5\n") ==
        "m.obj: 1 triangle is too small or thin for single precision");
  CHECK(noteOf(square + "v 0.5 1e-6 0\nf 1 2 3 4\nf 1 2 5\n").empty());
  // The same triangle is large enough where it is the mesh.
  CHECK(noteOf("v 5000 0 0\nv 5000.000001 0 0\nv 5000 0.000001 0\nf 1 2 3\n").empty());
}

TEST_CASE("an inwards mesh of glass is told by shape and volume; flip turns it") {
  TemporaryFolder folder;
  std::string const path = folder.path().string();
  Scene const scene = sceneOf(
      folder, cube(true, 10),
      meshShape("white") + ", " + meshShape("glass") + ", " + meshShape("glass", R"(, "name": "bowl", "flip": true)") +
          ", " + meshShape("glass", R"(, "name": "jar", "transform": [{"scale": [-1, 1, 1]}], "flip": false)"));
  std::string const said = ": the triangles of " + path +
                           "/m.obj face inwards (its volume is -8), so that its inside is taken for its outside; "
                           "\"flip\": true turns them";
  CHECK(scene.notes == Notes{path + "/s.json: /shapes/1" + said, path + "/s.json: /shapes/3 (\"jar\")" + said});
  REQUIRE(scene.meshes.size() == 2);  // one a direction
  CHECK(enclosedVolume(scene.meshes[0]).value() == doctest::Approx(-8));
  CHECK(enclosedVolume(scene.meshes[1]).value() == doctest::Approx(8));

  Notes const turned = sceneOf(folder, cube(false), meshShape("glass", R"(, "flip": true)")).notes;
  REQUIRE(turned.size() == 1);
  CHECK(turned[0].ends_with("no \"flip\" turns them"));
}

TEST_CASE("flip and a mirroring transform each turn a mesh as they should") {
  TemporaryFolder folder;
  const char* const mirror = R"(, "transform": [{"scale": [-1, 1, 1]}])";
  for (bool const inwards : {false, true})
    for (const char* transform : {"", mirror}) {
      std::string const flip = inwards ? R"(, "flip": true)" : "";
      Scene const scene = sceneOf(folder, cube(inwards), meshShape("glass", flip + transform));
      CHECK(scene.notes.empty());
      CHECK(flatVolume(flatten(scene, Instancing::never)) == doctest::Approx(8));
      FlatScene const placed = flatten(scene, Instancing::always);
      CHECK(flatVolume(*placed.meshes.at(0)) > 0);
    }
}

TEST_CASE("an open mesh has no inside; vertices in one place are one") {
  std::string open = cube(true);
  open.erase(open.rfind("f "));
  TemporaryFolder folder;
  CHECK(sceneOf(folder, open, meshShape("glass")).notes.empty());
  // Every face with vertices of its own, as many tools write them.
  std::string apart;
  Mesh const mesh = loadObj(writeFile(folder, "c.obj", cube(true)));
  for (const glm::uvec3& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        apart += (axis == 0 ? "v " : " ") + std::to_string(mesh.positions[t[i]][axis]) + (axis == 2 ? "\n" : "");
    apart += "f -3 -2 -1\n";
  }
  CHECK(sceneOf(folder, apart, meshShape("glass")).notes.size() == 1);
}

TEST_CASE("an opening in a wall's outline stays open") {
  TemporaryFolder folder;
  writeFile(folder, "door.obj",
            "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 3 2 0\nv 3 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8\n");
  Scene const scene = loadScene(writeFile(folder, "door.json", R"({
    "camera": {"position": [2, 1.5, 10], "target": [2, 1.5, 0], "fov": 24}, "film": {"width": 128, "height": 128},
    "materials": {"w": {"type": "diffuse", "albedo": 0.8}, "k": {"type": "diffuse", "albedo": 0}},
    "shapes": [{"type": "mesh", "file": "door.obj", "material": "w"},
      {"type": "sphere", "center": [2, 1.5, 20], "radius": 1, "material": "k", "emission": {"radiance": 100}}]})"));
  Settings settings = testing::settingsFor(Mode::path, 128, 128);
  settings.aov = Aov::albedo;
  double const edge = 20 * std::tan(12 * M_PI / 180);  // of what the picture shows of the wall's plane
  CHECK(testing::meanOf(testing::renderImage(scene, settings, 16)) ==
        doctest::Approx(0.8 * 8 / (edge * edge)).epsilon(0.003));
}

#ifdef ROPELIGHT_PROGRAM
TEST_CASE("info and render show the notes, and render --quiet does not") {
  TemporaryFolder folder;
  writeFile(folder, "m.obj", square + "v 9 9 9\nf 1 2 3 4\n");
  auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"m.obj", "--backend", "cpu", "--width", "16", "--height", "12"});
    Program program(ROPELIGHT_PROGRAM, arguments, folder.path());
    CHECK(program.exitCode() == 0);
    return std::pair(program.out(), program.err());
  };
  std::string const note = "m.obj: 1 vertex belongs to no face";
  CHECK(run({"info"}).first.find("note        " + note + "\n") != std::string::npos);
  CHECK(nlohmann::json::parse(run({"info", "--json", "-"}).first).at("notes") == nlohmann::json{note});
  CHECK(run({"render", "--iterations", "1"}).second.find("note: " + note + "\n") != std::string::npos);
  CHECK(run({"render", "--iterations", "1", "--quiet"}).second.find(note) == std::string::npos);
}
#endif
