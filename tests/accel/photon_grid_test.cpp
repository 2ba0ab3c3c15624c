// The photon grid: neighbour sets against testing every photon.

#include "accel/photon_grid/photon_grid.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/scenes/photon_cloud.h"
#include "tests/support/test_random.h"

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

/// Photon i has i in place of its path.
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
  grid.forEachNear(
      {p, Vec3(radius), radius * radius},
      [&](const PhotonPosition& photon, Real&) { return within(photon.p, p, radius); },
      [&](std::uint32_t k, Real, const PhotonPosition&) { ids.push_back(grid.powers[k].path); });
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
  int dense = 0, hashed = 0;
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
          ++(c.grid.dense ? dense : hashed);
          CHECK((c.grid.dense ? c.grid.cells <= table : c.grid.cells == table));
          CHECK(wrong == 0);
          CHECK(neighbours > 50);
        }
  }
  CHECK(dense > 50);
  CHECK(hashed > 20);
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
    for (double step : {0.1, 1.0 / 3, 0.7})
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3> points(300, Vec3(0));
        for (int i = 0; i < 300; ++i) points[std::size_t(i)][axis] = Real(offset + step * i);
        Real const radius = points[103][axis] - points[100][axis];
        for (double cells : {1.0 / 3, 1.0, 4.0})
          for (std::uint32_t table : {1u << 12, 32u}) {
            PhotonCloud const c(positionsOf(points), numbered(points.size()), boundsOf(points), cells * double(radius),
                                table);
            int wrong = 0;
            for (Vec3 p : points) wrong += found(c.grid, p, radius) != expected(points, p, radius);
            CHECK(wrong == 0);
          }
      }
}

TEST_CASE("a photon that only rounding brings within the radius is found across the border of its cell") {
  // query + radius rounds to the float below the radius, photon − query to the radius itself.
  for (int axis = 0; axis < 3; ++axis)
    for (Real radius : {Real(0.5), Real(0.25), Real(0.125)}) {
      Vec3 query(0.5f), photon(0.5f);
      photon[axis] = radius;
      query[axis] = -radius * Real(0.75) * machineEpsilon;
      CHECK(query[axis] + radius < photon[axis]);
      CHECK(within(photon, query, radius));
      PhotonCloud const c(positionsOf({photon}), numbered(1), {Vec3d(0), Vec3d(1)}, double(radius), 1u << 14);
      CHECK(found(c.grid, query, radius).size() == 1);
    }
}

TEST_CASE("a grid without photons is empty") {
  for (std::uint32_t table : {1u << 16, 8u}) {
    PhotonCloud const c({}, {}, Bounds{Vec3d(-1), Vec3d(1)}, 0.1, table);
    CHECK(found(c.grid, Vec3(0.5f), 10).empty());
  }
}

TEST_CASE("cells are not finer than the coordinates, and a query meets few of them") {
  TestRandom random(4);
  for (double where : {0.0, 1e6}) {
    CAPTURE(where);
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back(Vec3(random.inBox(1e5) + where) + Vec3(random.inBox(1e-3)));
    PhotonCloud const c(positionsOf(points), numbered(points.size()), boundsOf(points), 1e-6, 256);
    CHECK_FALSE(c.grid.dense);
    for (int n : c.grid.size) CHECK(n < 1 << 24);
    int wrong = 0;
    for (Vec3 p : points) wrong += found(c.grid, p, 1e-6f) != expected(points, p, 1e-6f);
    CHECK(wrong == 0);
  }
}

TEST_CASE("photons and queries far beyond the bounds are found") {
  TestRandom random(5);
  Bounds const bounds{Vec3d(0), Vec3d(1)};
  std::vector<Vec3> points;
  for (int i = 0; i < 1500; ++i) {
    Vec3d p = random.inBox(0.5) + 0.5;
    if (i % 3 > 0) p[int(random.below(3))] = random.between(-3, 4);
    if (i % 7 == 0) p[int(random.below(3))] *= 20;
    points.push_back(Vec3(p));
  }
  for (Real radius : {Real(0.1), Real(0.45), Real(3)})
    for (double cells : {0.5, 1.0, 3.0})
      for (std::uint32_t table : {1u << 20, 64u}) {
        PhotonCloud const c(positionsOf(points), numbered(points.size()), bounds, cells * double(radius), table);
        int wrong = 0;
        for (Vec3 p : queriesFor(points, bounds, radius))
          wrong += found(c.grid, p, radius) != expected(points, p, radius);
        CHECK(wrong == 0);
      }
}

TEST_CASE("a radius may be much larger or smaller than a cell") {
  TestRandom random(6);
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) points.push_back(Vec3(random.inBox(1)));
  Bounds const bounds = boundsOf(points);
  for (std::uint32_t table : {1u << 20, 256u}) {
    PhotonCloud const c(positionsOf(points), numbered(points.size()), bounds, 0.05, table);
    for (Real radius : {Real(0), Real(1e-7), Real(1e-3), Real(0.7), Real(5)}) {
      int wrong = 0;
      for (int i = 0; i < 30; ++i)
        wrong += found(c.grid, points[std::size_t(i)], radius) != expected(points, points[std::size_t(i)], radius);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("no bounds, no cell size and no number make a grid that reads beyond its table") {
  std::vector<Vec3> const points{Vec3(0), Vec3(1, 2, 3), Vec3(-1e30f), Vec3(3e38f)};
  Real const nan = std::numeric_limits<Real>::quiet_NaN();
  for (const Bounds& bounds : {Bounds{}, Bounds{Vec3d(0), Vec3d(0)}, Bounds{Vec3d(-3e38), Vec3d(3e38)}})
    for (double cell : {0.0, 1e-30, 1.0, 1e30, double(infinity)})
      for (std::uint32_t table : {1u, 64u}) {
        PhotonCloud const c(positionsOf(points), numbered(points.size()), bounds, cell, table);
        CHECK(found(c.grid, Vec3(0), 0).size() == 1);
        for (Real x : {nan, infinity, -infinity}) CHECK(found(c.grid, Vec3(x), 1).empty());
        CHECK(c.grid.key(Vec3(nan)) < c.grid.cells);
      }
}
