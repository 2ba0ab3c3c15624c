// The rays that benchmarks trace, against those that an independent program made and traced.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "measure/rays/meshes.h"
#include "measure/rays/ray_sets.h"

namespace ropelight {
namespace {

struct GivenRay {
  std::string set;
  std::uint32_t number = 0;
  Vec3d origin{}, direction{};
  double tMax = 0, t = 0;
  std::uint32_t primitive = 0;
};

std::filesystem::path dataFile(const std::string& name) {
  return std::filesystem::path(ROPELIGHT_SHARED_DATA) / "rays" / name;
}

bool present(const std::string& name) {
  if (std::filesystem::exists(dataFile(name))) return true;
  MESSAGE("skipped: there is no " << dataFile(name).string());
  return false;
}

/// By set, in the file's order.
std::map<std::string, std::vector<GivenRay>> readRays(const std::string& name) {
  std::map<std::string, std::vector<GivenRay>> sets;
  std::ifstream file(dataFile(name));
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    GivenRay r;
    std::string arrow, primitive;
    words >> r.set >> r.number;
    for (int a = 0; a < 3; ++a) words >> r.origin[a];
    for (int a = 0; a < 3; ++a) words >> r.direction[a];
    words >> r.tMax >> arrow >> r.t >> primitive;
    r.primitive = std::uint32_t(std::stoll(primitive));
    REQUIRE_MESSAGE(words, line);
    sets[r.set].push_back(r);
  }
  return sets;
}

Vec3d vectorOf(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Möller & Trumbore 1997 in double.
double distanceTo(const FlatTriangle& triangle, Vec3d origin, Vec3d direction) {
  constexpr double none = std::numeric_limits<double>::infinity();
  Vec3d const e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, p = glm::cross(direction, e2);
  double const inverse = 1 / glm::dot(e1, p);
  Vec3d const s = origin - triangle.a;
  double const u = glm::dot(s, p) * inverse;
  if (!(u >= 0 && u <= 1)) return none;
  Vec3d const q = glm::cross(s, e1);
  double const v = glm::dot(direction, q) * inverse;
  if (!(v >= 0 && u + v <= 1)) return none;
  double const t = glm::dot(e2, q) * inverse;
  return t > 0 ? t : none;
}

/// Every triangle for every ray.
RayTracer bruteForce(const FlatScene& scene) {
  return [&scene](std::span<const StreamRay> rays) {
    std::vector<StreamHit> hits;
    for (const StreamRay& r : rays) {
      Vec3d const origin = vectorOf(r.origin), direction = vectorOf(r.direction);
      double closest = r.tMax;
      std::uint32_t primitive = 0xFFFFFFFFu;
      for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        double const t = distanceTo(scene.triangles[i], origin, direction);
        if (t < closest) closest = t, primitive = std::uint32_t(i);
      }
      hits.push_back({float(closest), primitive});
    }
    return hits;
  };
}

double largest(Vec3d v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

struct Difference {
  int rays = 0, hits = 0, compared = 0;
};

/// Rays further apart than the tolerance, and hits of equal rays with another distance or primitive.
Difference compare(const RaySet& ours, const std::vector<GivenRay>& theirs, double tolerance) {
  Difference difference;
  REQUIRE(ours.rays.size() == theirs.size());
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    const StreamRay& ray = ours.rays[k];
    const GivenRay& given = theirs[k];
    ++difference.compared;
    bool const sameRay = largest(vectorOf(ray.origin) - given.origin) <= tolerance &&
                         largest(vectorOf(ray.direction) - given.direction) <= tolerance &&
                         std::abs(double(ray.tMax) - given.tMax) <= tolerance * given.tMax;
    if (!sameRay) ++difference.rays;
    if (!sameRay) continue;
    const StreamHit& hit = ours.hits[k];
    double const error = std::abs(double(hit.t) - given.t);
    bool const occluded = given.t == 1;  // as the file has it for any-hit rays
    bool const sameHit =
        ours.anyHit ? hit.found() == occluded : hit.primitive == given.primitive && error <= 1e-5 * given.t + 1e-6;
    if (!sameHit) ++difference.hits;
  }
  return difference;
}

std::vector<std::uint32_t> numbersOf(const std::vector<GivenRay>& rays) {
  std::vector<std::uint32_t> numbers;
  for (const GivenRay& r : rays) numbers.push_back(r.number);
  return numbers;
}

void checkAgainst(const std::string& file, std::vector<FlatTriangle> triangles, const RayView& view) {
  auto const given = readRays(file);
  REQUIRE(given.count("primary") == 1);
  normalise(triangles);
  appendRoom(triangles);
  FlatScene const scene = triangleScene(std::move(triangles));
  auto const sets = makeRaySets(scene, view, RayImage{}, numbersOf(given.at("primary")), bruteForce(scene));
  REQUIRE(sets.size() == std::size(raySetNames));
  for (const RaySet& set : sets) {
    CAPTURE(set.name);
    Difference const d = compare(set, given.at(set.name), set.name == "primary" ? 1e-6 : 1e-5);
    CHECK(d.compared == 64);
    CHECK(d.rays == 0);
    CHECK(d.hits == 0);
  }
}

}  // namespace

TEST_CASE("rays on the bunny are those of the independent tracer") {
  if (!present("bunny.obj") || !present("bunny5k.txt")) return;
  checkAgainst("bunny5k.txt", objTriangles(dataFile("bunny.obj")), outsideView);
}

TEST_CASE("rays on a million triangles are those of the independent tracer" * doctest::test_suite("slow")) {
  if (!present("bumpy1M.txt") || !present("bumpy1M-in.txt")) return;
  std::vector<FlatTriangle> const bumpy = bumpySphere(1001, 501);
  REQUIRE(bumpy.size() + roomTriangles == 999010);
  checkAgainst("bumpy1M.txt", bumpy, outsideView);
  checkAgainst("bumpy1M-in.txt", bumpy, insideView);
}

TEST_CASE("the bumpy sphere is closed, faces out and has the size asked for") {
  for (std::uint32_t const wanted : {10u, 32u, 100u, 316u, 1000u, 4980u, 31623u}) {
    CAPTURE(wanted);
    std::vector<FlatTriangle> const triangles = bumpySphereOf(wanted);
    CHECK(std::abs(double(triangles.size()) / wanted - 1) < 0.03);
    double volume = 0;
    Vec3d areaVector(0.0);
    for (const FlatTriangle& t : triangles) {
      volume += glm::dot(t.a, glm::cross(t.b, t.c)) / 6;
      areaVector += glm::cross(t.b - t.a, t.c - t.a);
    }
    CHECK(volume > 0.4);
    CHECK(volume < 5);
    CHECK(largest(areaVector) < 1e-9);  // zero for a closed surface (divergence theorem)
  }
}

TEST_CASE("the room faces in and encloses its volume") {
  std::vector<FlatTriangle> room;
  appendRoom(room);
  REQUIRE(room.size() == roomTriangles);
  double volume = 0;
  for (const FlatTriangle& t : room) volume += glm::dot(t.a, glm::cross(t.b, t.c)) / 6;
  CHECK(volume == doctest::Approx(-125));
}

TEST_CASE("normalising centres the box and makes its longest half-extent 1") {
  std::vector<FlatTriangle> triangles = {{{10, 2, 3}, {14, 2, 3}, {10, 4, 3.5}}};
  normalise(triangles);
  CHECK(triangles[0].a == Vec3d(-1, -0.5, -0.125));
  CHECK(triangles[0].b == Vec3d(1, -0.5, -0.125));
  CHECK(triangles[0].c == Vec3d(-1, 0.5, 0.125));
  std::vector<FlatTriangle> point = {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
  CHECK_THROWS(normalise(point));
}

TEST_CASE("a ray whose forerunner hit nothing hits nothing") {
  FlatScene const scene = triangleScene({{{-9, -9, -2}, {0, 9, -2}, {0, -9, -2}}});  // half of the view
  auto const sets = makeRaySets(scene, insideView, {32, 32}, bruteForce(scene));
  int missed = 0;
  for (std::size_t k = 0; k < 1024; ++k) {
    if (sets[0].hits[k].found()) continue;
    ++missed;
    CHECK(sets[1].rays[k].tMax == 0);
    CHECK(!sets[1].hits[k].found());
  }
  CHECK(missed > 100);
  CHECK(missed < 900);
}

}  // namespace ropelight
