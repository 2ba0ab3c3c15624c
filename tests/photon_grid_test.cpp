// The photon grid: neighbour sets against testing every photon, packing, and the stages that fill it.

#include "accel/photon_grid.h"

#include <doctest/doctest.h>

#include <bit>
#include <string>

#include "render/backend/radix_sort.h"
#include "render/integrator/stages/bin_photons.h"
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

TEST_CASE("packed directions are within 10⁻⁴ of what went in") {
  TestRandom random(5);
  std::vector<Vec3> directions;
  for (int i = 0; i < 100000; ++i) directions.push_back(Vec3(random.direction()));
  for (int i = 0; i < 27; ++i) {
    Vec3 const v(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);  // axes, edges and corners of the octahedron
    if (v != Vec3(0)) directions.push_back(glm::normalize(v));
  }
  directions.push_back(Vec3(-0.0f, -0.0f, -1));
  double worst = 0, length = 0;
  for (Vec3 v : directions) {
    Vec3d const u(unpackDirection(packDirection(v)));
    worst = std::max(worst, glm::length(glm::cross(u, Vec3d(v))));
    length = std::max(length, std::abs(glm::length(u) - 1));
    if (glm::dot(u, Vec3d(v)) < 0.5) FAIL("turned round");
  }
  CHECK(worst < 1e-4);
  CHECK(length < 1e-6);
}

TEST_CASE("equal directions are packed alike and packing them again changes nothing") {
  TestRandom random(6);
  int moved = 0;
  for (int i = 0; i < 10000; ++i) {
    std::uint32_t const bits = packDirection(Vec3(random.direction()));
    moved += packDirection(unpackDirection(bits)) != bits;
  }
  CHECK(moved < 10);  // halves may round either way
}

TEST_CASE("the stages order the photons by cell, tails included, and leave the rest of the list out") {
  constexpr std::uint32_t paths = 200, stripe = 3, tails = 600, capacity = 1500;
  TestRandom random(7);
  std::vector<DepositCount> counts(paths), offsets(paths + 1);
  for (std::uint32_t p = 0; p < paths; ++p) {
    std::uint32_t const n = random.below(8);
    counts[p] = {n, n > stripe ? n - stripe : 0, n > stripe ? 1u : 0u};
    offsets[p + 1] = offsets[p] + counts[p];
  }
  std::uint32_t const total = offsets[paths].all;
  REQUIRE((total < capacity && offsets[paths].tail < tails && offsets[paths].tail > 10));

  std::vector<PhotonPosition> slotPositions(paths * stripe + tails), positions(capacity);
  std::vector<PhotonPower> slotPowers(paths * stripe + tails), powers(capacity);
  std::vector<std::uint32_t> keys(capacity), slots(capacity), scratch(2 * capacity);
  IterationState state;
  PhotonStore store;
  store.paths = paths;
  store.stripe = stripe;
  store.tailCapacity = tails;
  store.photonCapacity = capacity;
  store.positions = {slotPositions.data(), std::uint32_t(slotPositions.size())};
  store.powers = {slotPowers.data(), std::uint32_t(slotPowers.size())};
  store.counts = {counts.data(), paths};
  store.offsets = {offsets.data(), paths + 1};
  store.keys = {keys.data(), capacity};
  store.slots = {slots.data(), capacity};
  store.state = {&state, 1};
  std::vector<Vec3> points;
  for (std::uint32_t p = 0; p < paths; ++p)
    for (std::uint32_t j = 0; j < counts[p].all; ++j) {
      std::uint32_t const slot = store.slotOf(p, j);
      CHECK(slotPowers.at(slot).edges == 0);  // no slot twice
      points.push_back(Vec3(random.inBox(1)));
      slotPositions[slot] = {points.back(), 0};
      slotPowers[slot] = {Rgb(1.0f), std::uint32_t(points.size())};
    }

  for (std::uint32_t table : {1u << 12, 64u}) {
    PhotonGrid grid;
    PhotonCloud::layOut(grid, boundsOf(points), 0.2, table);
    CHECK(grid.dense == (table == 1u << 12));
    std::vector<std::uint32_t> starts(grid.cells + 1, 12345);
    Tally tally;
    for (std::uint32_t p = 0; p < paths; ++p) WriteKeys{store, grid}(p, tally);
    for (std::uint32_t k = 0; k < capacity; ++k) PadKeys{store, grid.cells}(k, tally);
    radixSortPairs(keys.data(), slots.data(), scratch.data(), scratch.data() + capacity, capacity,
                   std::bit_width(grid.cells), 2);
    OrderPhotons const order{
        store, grid.cells, {starts.data(), grid.cells + 1}, {positions.data(), capacity}, {powers.data(), capacity}};
    for (std::uint32_t k = 0; k <= capacity; ++k) order(k, tally);

    CHECK(starts.front() == 0);
    CHECK(starts.back() == total);
    grid.starts = {starts.data(), grid.cells + 1};
    grid.positions = {positions.data(), capacity};
    grid.powers = {powers.data(), capacity};
    int misplaced = 0, wrong = 0;
    for (std::uint32_t c = 0; c < grid.cells; ++c)
      for (std::uint32_t k = starts[c]; k < starts[c + 1]; ++k) {
        misplaced += grid.key(positions[k].p) != c || points.at(powers[k].edges - 1) != positions[k].p;
        misplaced += k > starts[c] && powers[k].edges <= powers[k - 1].edges;  // stable: by path, then deposit
      }
    for (Vec3 p : points) {
      std::vector<std::uint32_t> ids = found(grid, p, 0.2f);
      for (std::uint32_t& id : ids) --id;
      wrong += ids != expected(points, p, 0.2f);
    }
    CHECK(misplaced == 0);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a halted iteration orders no photons") {
  constexpr std::uint32_t capacity = 40, cells = 4;  // for photons that are more than that
  std::vector<DepositCount> counts(1, {2 * capacity, 0, 0}), offsets{{0, 0, 0}, {2 * capacity, 0, 0}};
  std::vector<std::uint32_t> keys(capacity, 0), slots(capacity, 0), starts(cells + 1, 12345);
  std::vector<PhotonPosition> positions(capacity);
  std::vector<PhotonPower> powers(capacity);
  IterationState state;
  state.halt = 1;
  PhotonStore store;
  store.paths = 1;
  store.photonCapacity = store.stripe = capacity;
  store.counts = {counts.data(), 1};
  store.offsets = {offsets.data(), 2};
  store.keys = {keys.data(), capacity};
  store.slots = {slots.data(), capacity};
  store.state = {&state, 1};
  Tally tally;
  WriteKeys{store, PhotonGrid{}}(0, tally);
  for (std::uint32_t k = 0; k < capacity; ++k) PadKeys{store, cells}(k, tally);
  OrderPhotons const order{
      store, cells, {starts.data(), cells + 1}, {positions.data(), capacity}, {powers.data(), capacity}};
  for (std::uint32_t k = 0; k <= capacity; ++k) order(k, tally);
  CHECK(starts == std::vector<std::uint32_t>(cells + 1, 0));
}
