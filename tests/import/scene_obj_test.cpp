// OBJ meshes, and the scene that is made around one.

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "render/import/load.h"
#include "render/import/obj/obj.h"
#include "render/scene/transform.h"
#include "tests/support/scene_files.h"
#include "tests/support/test_random.h"

using namespace ropelight;
namespace fs = std::filesystem;

namespace {

Mesh loadText(const std::string& text) {
  TemporaryFolder folder;
  return loadObj(writeFile(folder, "mesh.obj", text));
}

double signedVolume(const Mesh& mesh) {
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles)
    volume += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6;
  return volume;
}

/// Every directed edge has its opposite.
bool isClosed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    auto const opposite = edges.find({edge.first.second, edge.first.first});
    return opposite != edges.end() && opposite->second == edge.second;
  });
}

}  // namespace

TEST_CASE("polygons become fans around their first vertex") {
  Mesh const mesh = loadText("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\nf 3 4 5\n");
  REQUIRE(mesh.triangles.size() == 4);
  CHECK(mesh.triangles[0] == glm::uvec3(0, 1, 2));
  CHECK(mesh.triangles[1] == glm::uvec3(0, 2, 3));
  CHECK(mesh.triangles[2] == glm::uvec3(0, 3, 4));
  CHECK(mesh.triangles[3] == glm::uvec3(2, 3, 4));
}

TEST_CASE("every form of a face is understood, also counted backwards and across line ends of any kind") {
  Mesh const mesh = loadText(
      "# a comment\r\nmtllib none.mtl\ro thing\ng a b\nusemtl x\ns off\n\n  v  +1.5e0 -2 .5 1.0\r\nv 1 0 0\rv 0 1 0\n"
      "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n\tf\t1/1/1 2/1/1 3/1/1 \nf -3 -2 -1\nf -3/-1/-1 "
      "-2/-1/-1 "
      "-1/-1/-1");
  REQUIRE(mesh.positions.size() == 3);
  CHECK(mesh.positions[0] == Vec3d(1.5, -2, 0.5));
  REQUIRE(mesh.triangles.size() == 6);
  for (const glm::uvec3& triangle : mesh.triangles) CHECK(triangle == glm::uvec3(0, 1, 2));
}

TEST_CASE("a backslash continues a line, whatever ends it, and a comment does not go on") {
  std::string const corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 3 0\nv 0 2 0\n";
  for (const char* face :
       {"f 1 2 3 \\\n4 5\n", "f 1 2 3 \\\r\n4 5\r\n", "f 1 2 3\\\r4 5", "f 1 2 3 \\ \t\n  4\t5",
        "f\\\n1 2 \\\n3 4 \\\n5 \\", "f 1 2 3 \\ # some\n4 5 # more \\\n", "f 1 2 3 4 5 # C:\\\n# \\\n"}) {
    CAPTURE(face);
    Mesh const mesh = loadText(corners + face);
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  }
  // A comment that ends in a backslash does not swallow the line below it.
  CHECK(loadText("# from C:\\meshes\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").positions.size() == 3);
}

TEST_CASE("comments may follow a statement, also without a blank") {
  Mesh const mesh = loadText("v 0 0 0#one\nv 1 0 0 # two\nv 0 1 0\nf 1 2 3 # last face\nf 3 2 1# glued\n#f 9 9 9\n");
  CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 0}});
}

TEST_CASE("a byte order mark is skipped") {
  Mesh const mesh = loadText("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 0\nf 1 2 3 4\n");
  CHECK(mesh.positions.size() == 5);
  CHECK(mesh.positions[mesh.triangles[0].x] == Vec3d(0));
}

TEST_CASE("weights, colours and other statements are read past") {
  Mesh const mesh = loadText(
      "mtllib a.mtl\nmtllib b c.mtl\nv 0 0 0 1\nv 1 0 0 0.5 0.25 1\nv 0 1 0 1 0.5 0.25 1\nvp 1 2\nfo 1 2 3\n"
      "usemtl \xC3\xA9\nunheard of\nf 1/ 2// 3/4/\n");
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.triangles.size() == 2);
}

TEST_CASE("coordinates are the nearest doubles, however they are written") {
  Mesh const mesh = loadText(
      "v 1E-400 -1e-99999999999999999999 0.000e5000\nv 4.9e-324 123456789012345678901234567890e-29 +.5\n"
      "v 0.1 2. 00017.30\nv 1e-5000000 0.00000001e-320 1234e-330\nf 1 2 3\n");
  CHECK(mesh.positions[0] == Vec3d(0));
  CHECK(mesh.positions[1] == Vec3d(4.9e-324, 1.23456789012345678901234567890, 0.5));
  CHECK(mesh.positions[2] == Vec3d(0.1, 2, 17.3));
  CHECK(mesh.positions[3] == Vec3d(0, 0, 0));
  TestRandom random(3);
  std::string text;
  std::vector<double> expected;
  for (int i = 0; i < 3000; ++i) {
    expected.push_back(random.between(-1000, 1000) * random.unit());
    text += fmt::format("{}{:.17g}{}", i % 3 == 0 ? "v " : " ", expected.back(), i % 3 == 2 ? "\n" : "");
  }
  Mesh const many = loadText(text + "f 1 2 3\n");
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) wrong += many.positions[std::size_t(i / 3)][i % 3] != expected[std::size_t(i)];
  CHECK(wrong == 0);
}

TEST_CASE("an OBJ alone becomes a scene with camera, room and light") {
  TemporaryFolder folder;
  // An upright triangle pair, far from the origin and small.
  Scene const scene = loadScene(writeFile(folder, "Thing.OBJ", "v 100 50 7\nv 100.1 50 7\nv 100 50.1 7.05\nf 1 2 3\n"));
  CHECK(scene.name == "Thing");
  REQUIRE(scene.shapes.size() == 3);
  CHECK(scene.shapes[0].kind == ShapeKind::mesh);
  const ShapeDesc& room = scene.shapes[1];
  Mat4d const toRoom = glm::inverse(room.toWorld);
  auto inRoom = [&](Vec3d p) {
    Vec3d const q = glm::abs(transformPoint(toRoom, p));
    return std::max({q.x, q.y, q.z}) < 1;
  };
  CHECK(inRoom(scene.camera.position));
  for (const Vec3d& p : scene.meshes[0].positions) CHECK(inRoom(p));
  const ShapeDesc& light = scene.shapes[2];
  REQUIRE(light.emission);
  for (Vec3d corner : {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)})
    CHECK(inRoom(transformPoint(light.toWorld, corner)));

  // The light shines down, and every vertex projects into the middle of the picture.
  Vec3d normal = transformVector(light.toWorld, {0, 0, 1});
  if (light.emission->side == Side::in) normal = -normal;
  CHECK(normal.y < 0);
  Vec3d const forward = glm::normalize(scene.camera.target - scene.camera.position);
  for (const Vec3d& p : scene.meshes[0].positions) {
    Vec3d const toVertex = glm::normalize(p - scene.camera.position);
    CHECK(glm::dot(toVertex, forward) > std::cos(scene.camera.verticalFov / 2 * 3.14159265 / 180));
  }
}

TEST_CASE("vertices that no face uses do not move the camera of an OBJ alone") {
  TemporaryFolder folder;
  std::string const mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  Scene const alone = loadScene(writeFile(folder, "a.obj", mesh));
  Scene const lamp = loadScene(writeFile(folder, "b.obj", mesh + "v 1000 1000 0\n"));
  CHECK(lamp.camera == alone.camera);
  CHECK(lamp.notes == std::vector<std::string>{(folder / "b.obj").string() + ": 1 vertex belongs to no face"});
}

TEST_CASE("the bunny loads") {
  fs::path const path = fs::path(ROPELIGHT_SHARED_DATA) / "rays/bunny.obj";
  if (!fs::exists(path)) {
    MESSAGE("skipped: " << path.string() << " is not there");
    return;
  }
  Scene const scene = loadScene(path);
  CHECK(scene.meshes[0].positions.size() == 2503);
  CHECK(scene.meshes[0].triangles.size() == 4968);
  CHECK(scene.meshes[0].positions[0].y == doctest::Approx(0.130320));
}

TEST_CASE("the script's bumpy mesh is closed and faces outwards") {
  TemporaryFolder folder;
  std::string const out = (folder / "bumpy.obj").string();
  std::string const script = std::string(ROPELIGHT_ASSETS) + "/../scripts/make_bumpy_mesh.py";
  if (std::system("python3 --version > /dev/null 2>&1") != 0) {
    MESSAGE("skipped: python3 is not there");
    return;
  }
  std::string const command = "python3 '" + script + "' --segments 80 --bands 40 --out '" + out + "' > /dev/null";
  REQUIRE(std::system(command.c_str()) == 0);
  Mesh const mesh = loadObj(out);
  CHECK(mesh.positions.size() == 80 * 39 + 2);
  CHECK(mesh.triangles.size() == 2 * 80 * 39);
  CHECK(isClosed(mesh));
  CHECK(signedVolume(mesh) == doctest::Approx(4.0 / 3 * 3.14159265).epsilon(0.05));
}
