// OBJ meshes, and the scene that is made around one.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "render/scene/load.h"
#include "render/scene/obj.h"
#include "render/scene/transform.h"
#include "tests/scene_files.h"

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
