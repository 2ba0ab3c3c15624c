// From photons in slots to photons by cell, and how their normals are packed.

#include "render/integrator/stages/bin_photons.h"

#include <doctest/doctest.h>

#include <bit>

#include "render/backend/radix_sort.h"
#include "tests/photon_cloud.h"
#include "tests/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

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
      CHECK((slotPowers.at(slot).edges == 0));  // no slot twice
      points.push_back(Vec3(random.inBox(1)));
      slotPositions[slot] = {points.back(), 0};
      slotPowers[slot] = {Rgb(1.0f), std::uint32_t(points.size())};
    }

  for (std::uint32_t table : {1u << 12, 64u}) {
    PhotonGrid grid;
    PhotonCloud::layOut(grid, Bounds{Vec3d(-1), Vec3d(1)}, 0.2, table);
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
    int misplaced = 0;
    for (std::uint32_t c = 0; c < grid.cells; ++c)
      for (std::uint32_t k = starts[c]; k < starts[c + 1]; ++k) {
        misplaced += grid.key(positions[k].p) != c || points.at(powers[k].edges - 1) != positions[k].p;
        misplaced += k > starts[c] && powers[k].edges <= powers[k - 1].edges;  // stable: by path, then deposit
      }
    CHECK(misplaced == 0);
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
