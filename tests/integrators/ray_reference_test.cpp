// Rays that an independent ray tracer traced through a mesh in a room, with its hits.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "render/flatten/flatten.h"
#include "render/import/obj/obj.h"
#include "render/intersection/intersect.h"
#include "tests/scenes/host_scene.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

struct ReferenceRay {
  Ray ray;
  double t = 0;             ///< closest hit; for shadow rays 1 where occluded, else −1
  std::uint32_t primitive;  ///< in file order; of no meaning for shadow rays
};

/// By the name of the set. Lines: set index origin direction tMax -> t primitive.
std::map<std::string, std::vector<ReferenceRay>> readRays(const std::filesystem::path& file) {
  std::map<std::string, std::vector<ReferenceRay>> sets;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string set, arrow;
    ReferenceRay r;
    Vec3 &o = r.ray.origin, &d = r.ray.direction;
    words >> set >> arrow >> o.x >> o.y >> o.z >> d.x >> d.y >> d.z >> r.ray.tMax >> arrow >> r.t >> r.primitive;
    if (words) sets[set].push_back(r);
  }
  return sets;
}

/// The room [−2.5, 2.5]³: walls −z, +z, −y, +y, −x, +x, each cut along the diagonal from its lowest corner.
void appendRoom(std::vector<FlatTriangle>& triangles) {
  static constexpr int walls[12][3] = {{0, 3, 1}, {0, 2, 3}, {4, 6, 7}, {4, 7, 5}, {0, 5, 4}, {0, 1, 5},
                                       {2, 7, 3}, {2, 6, 7}, {0, 6, 2}, {0, 4, 6}, {1, 7, 5}, {1, 3, 7}};
  auto const corner = [](int i) { return 2.5 * Vec3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1); };
  for (const auto& w : walls) triangles.push_back({corner(w[0]), corner(w[1]), corner(w[2])});
}

/// The bounding box's center goes to the origin and its longest half-extent becomes 1.
FlatScene meshInRoom(const Mesh& mesh) {
  Bounds bounds;
  for (Vec3d p : mesh.positions) bounds.grow(p);
  Vec3d const center = 0.5 * (bounds.min + bounds.max), half = 0.5 * bounds.extent();
  double const scale = 1 / std::max({half.x, half.y, half.z});
  std::vector<FlatTriangle> triangles;
  for (glm::uvec3 t : mesh.triangles)
    triangles.push_back({(mesh.positions[t.x] - center) * scale, (mesh.positions[t.y] - center) * scale,
                         (mesh.positions[t.z] - center) * scale});
  appendRoom(triangles);
  return flatten(SceneBuilder().mesh(triangles).scene);
}

/// The obj file's six digits move surfaces by 10⁻⁶ of their size: by that much over the cosine of incidence for t.
bool agrees(const HostScene& scene, const ReferenceRay& r, const Hit& hit) {
  if (!hit.found() || hit.primitive != r.primitive) return false;
  Surface const s = surfaceAt<feature::all>(scene.view(), r.ray, hit);
  double const cosine = std::abs(double(dot(s.n, r.ray.direction)));
  return std::abs(double(hit.t) - r.t) <= 5e-6 * (1 + r.t) / cosine;
}

}  // namespace

TEST_CASE("an independent ray tracer finds the same triangles at the same distances") {
  std::filesystem::path const folder = std::filesystem::path(ROPELIGHT_SHARED_DATA) / "rays";
  if (!std::filesystem::exists(folder / "bunny5k.txt") || !std::filesystem::exists(folder / "bunny.obj")) {
    MESSAGE("the reference rays are not here");
    return;
  }
  HostScene const scene(meshInRoom(loadObj(folder / "bunny.obj")), KdConfig{});
  REQUIRE(scene.flat().primitiveCount() == 4980);
  auto const sets = readRays(folder / "bunny5k.txt");
  REQUIRE(sets.size() == 7);
  int mesh = 0;
  for (const auto& [name, rays] : sets) {
    CAPTURE(name);
    REQUIRE(rays.size() == 64);
    int wrong = 0;
    for (const ReferenceRay& r : rays) {
      if (name == "shadow1") {
        wrong += occluded<feature::all>(scene.view(), r.ray, noPrimitive) != (r.t > 0);
      } else {
        Hit const hit = closestHit<feature::all>(scene.view(), r.ray);
        mesh += hit.primitive < 4968;
        wrong += !agrees(scene, r, hit);
      }
    }
    CHECK(wrong == 0);
  }
  CHECK(mesh > 30);
}
