// The photon grid: neighbour sets against testing every photon.

#include "accel/photon_grid.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/photon_cloud.h"
#include "tests/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

struct Cloud {
  std::string name;
  std::vector<Vec3> points;
};

/// 1500 photons each, at a spacing for which radii about 0.3 find dozens.
std::vector<Cloud> clouds() {
  TestRandom random(1);
  std::vector<Cloud> list(8);
  list[0].name = "a volume around the origin";
  list[1].name = "one point many times";
  list[2].name = "one cell";
  list[3].name = "the faces and corners of a box";
  list[4].name = "negative coordinates";
  list[5].name = "a million away";
  list[6].name = "a plane";
  list[7].name = "points of a lattice";
  for (int i = 0; i < 1500; ++i) {
    Vec3d const p = random.inBox(1.2);
    list[0].points.push_back(Vec3(p));
    list[1].points.push_back(Vec3(0.3f, 0.4f, 0.5f));
    list[2].points.push_back(Vec3(0.05 * p));
    Vec3d onBox = p;
    onBox[int(random.below(3))] = random.below(2) ? 1.2 : -1.2;
    if (random.below(4) == 0) onBox = glm::sign(p) * 1.2;
    list[3].points.push_back(Vec3(onBox));
    list[4].points.push_back(Vec3(p - 50.0));
    list[5].points.push_back(Vec3(p * 3.0 + Vec3d(1e6, -1e6, 1e6)));
    list[6].points.push_back(Vec3(p.x, 0.25, p.z));
    list[7].points.push_back(Vec3(glm::round(p * 10.0) / 10.0));
  }
  return list;
}

Bounds boundsOf(const std::vector<Vec3>& points) {
  Bounds b;
  for (Vec3 p : points) b.grow(Vec3d(p));
  return b;
}

/// Photon i has i in place of its path's edges.
std::vector<PhotonPosition> positionsOf(const std::vector<Vec3>& points) {
  std::vector<PhotonPosition> positions;
  for (Vec3 p : points) positions.push_back({p, packDirection(Vec3(0, 0, 1))});
  return positions;
}

std::vector<PhotonPower> numbered(std::size_t n) {
  std::vector<PhotonPower> powers;
  for (std::size_t i = 0; i < n; ++i) powers.push_back({Rgb(1.0f), std::uint32_t(i)});
  return powers;
}

bool within(Vec3 a, Vec3 b, Real radius) { return lengthSquared(a - b) <= radius * radius; }

/// Photons within the radius of p, by number; one that is visited twice is there twice.
std::vector<std::uint32_t> found(const PhotonGrid& grid, Vec3 p, Real radius) {
  std::vector<std::uint32_t> ids;
  grid.forEachIn(grid.around(p, Vec3(radius)), [&](std::uint32_t k) {
    if (within(grid.positions[k].p, p, radius)) ids.push_back(grid.powers[k].edges);
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<std::uint32_t> expected(const std::vector<Vec3>& points, Vec3 p, Real radius) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (within(points[i], p, radius)) ids.push_back(i);
  return ids;
}

/// Photons, places between and beyond them, and places exactly one radius along an axis from one.
std::vector<Vec3> queriesFor(const std::vector<Vec3>& points, const Bounds& bounds, Real radius) {
  TestRandom random(2);
  std::vector<Vec3> queries{Vec3(bounds.min), Vec3(bounds.max), Vec3(bounds.min - 100.0), Vec3(bounds.max + 100.0)};
  for (int i = 0; i < 40; ++i) {
    Vec3 const p = points[random.below(points.size())];
    queries.push_back(p);
    queries.push_back(p + Vec3(random.direction()) * radius);
    Vec3 beside = p;
    beside[int(random.below(3))] += random.below(2) ? radius : -radius;
    queries.push_back(beside);
  }
  return queries;
}

}  // namespace

TEST_CASE("the grid finds the photons within a radius, each once, dense or hashed") {
  for (const Cloud& cloud : clouds()) {
    CAPTURE(cloud.name);
    Bounds const bounds = boundsOf(cloud.points);
    for (Real radius : {Real(0.3), Real(1)})
      for (double cells : {0.5, 1.0, 1.7, 4.0})
        for (std::uint32_t table : {1u << 20, 1024u, 64u, 1u}) {
          double const cell = cells * double(radius);
          PhotonCloud const c(positionsOf(cloud.points), numbered(cloud.points.size()), bounds, cell, table);
          int wrong = 0;
          std::size_t neighbours = 0;
          for (Vec3 p : queriesFor(cloud.points, bounds, radius)) {
            std::vector<std::uint32_t> const e = expected(cloud.points, p, radius);
            wrong += found(c.grid, p, radius) != e;
            neighbours += e.size();
          }
          CAPTURE(cell);
          CAPTURE(table);
          CHECK((c.grid.dense || c.grid.cells == table));
          CHECK((c.grid.dense ? table > 1 : table < 1u << 20));
          CHECK(wrong == 0);
          CHECK(neighbours > 50);
        }
  }
}

TEST_CASE("photons and queries outside the bounds by rounding are found") {
  std::vector<Vec3> points;
  TestRandom random(3);
  Bounds const bounds{Vec3d(-1.1, 0.3, 2), Vec3d(1.3, 0.3, 7.7)};
  for (int i = 0; i < 500; ++i) {
    Vec3 p(random.between(-1.1, 1.3), 0.3, random.between(2, 7.7));
    for (int a = 0; a < 3; ++a) p[a] = std::nextafter(p[a], random.below(2) ? infinity : -infinity);
    points.push_back(p);
  }
  for (std::uint32_t table : {1u << 16, 16u}) {
    PhotonCloud const c(positionsOf(points), numbered(points.size()), bounds, 0.25, table);
    int wrong = 0;
    for (Vec3 p : points) wrong += found(c.grid, p, 0.25f) != expected(points, p, 0.25f);
    CHECK(wrong == 0);
  }
}

TEST_CASE("photons one radius away on the borders of the cells are found") {
  for (double offset : {0.0, -7.3, 1000.1})
    for (double step : {0.1, 1.0 / 3, 0.7}) {
      std::vector<Vec3> points;
      for (int i = 0; i < 300; ++i) points.push_back(Vec3(offset + step * i, 0, 0));
      Real const radius = points[103].x - points[100].x;
      for (std::uint32_t table : {1u << 12, 32u}) {
        PhotonCloud const c(positionsOf(points), numbered(points.size()), boundsOf(points), double(radius), table);
        int wrong = 0;
        for (Vec3 p : points) wrong += found(c.grid, p, radius) != expected(points, p, radius);
        CHECK(wrong == 0);
      }
    }
}

TEST_CASE("a grid without photons is empty") {
  for (std::uint32_t table : {1u << 16, 8u}) {
    PhotonCloud const c({}, {}, Bounds{Vec3d(-1), Vec3d(1)}, 0.1, table);
    CHECK(found(c.grid, Vec3(0.5f), 10).empty());
  }
}

TEST_CASE("a grid with more cells than integers clamps and still finds everything") {
  TestRandom random(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(Vec3(random.inBox(1e5)) + Vec3(random.inBox(1e-3)));
  PhotonCloud const c(positionsOf(points), numbered(points.size()), boundsOf(points), 1e-6, 256);
  CHECK_FALSE(c.grid.dense);
  int wrong = 0;
  for (Vec3 p : points) wrong += found(c.grid, p, 1e-6f) != expected(points, p, 1e-6f);
  CHECK(wrong == 0);
}
