// From photons in slots to photons by cell, and how their normals are packed.

#include "render/photons/bin_photons.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "render/core/radix_sort.h"
#include "tests/scenes/photon_cloud.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

void findCells(const std::vector<std::uint32_t>& keys, const IterationState& state, std::vector<std::uint32_t>& starts,
               std::uint32_t batch) {
  Tally tally;
  std::uint32_t const cells = std::uint32_t(starts.size()) - 1;
  FindCells const find{
      {keys.data(), std::uint32_t(keys.size())}, {&state, 1}, {starts.data(), cells + 1}, cells, batch};
  for (std::uint32_t i = 0; i < FindCells::calls(cells, batch); ++i) find(i, tally);
}

/// Photons in the slots of their paths, some of them in tails, as tracing leaves them.
struct Stored {
  static constexpr std::uint32_t paths = 200, stripe = 3, tails = 600, capacity = 1500;

  std::vector<DepositCount> counts = std::vector<DepositCount>(paths), offsets = std::vector<DepositCount>(paths + 1);
  std::vector<Photon> photons = std::vector<Photon>(paths * stripe + tails);
  std::vector<PhotonPosition> positions = std::vector<PhotonPosition>(capacity);
  std::vector<PhotonPower> powers = std::vector<PhotonPower>(capacity);
  std::vector<std::uint32_t> keys = std::vector<std::uint32_t>(capacity), slots = keys;
  std::vector<Vec3> points;  ///< by path, then deposit; a photon's power.path is its index + 1
  IterationState state;
  PhotonStore store;

  Stored() {
    TestRandom random(7);
    count(random);
    store.paths = paths;
    store.stripe = stripe;
    store.tailCapacity = tails;
    store.photonCapacity = capacity;
    store.photons = {photons.data(), std::uint32_t(photons.size())};
    store.counts = {counts.data(), paths};
    store.offsets = {offsets.data(), paths + 1};
    store.keys = {keys.data(), capacity};
    store.slots = {slots.data(), capacity};
    store.state = {&state, 1};
    fill(random);
  }
  Stored(const Stored&) = delete;

  std::uint32_t total() const { return offsets[paths].all; }

  /// All stages, into cells that begin at `starts`.
  void bin(const PhotonGrid& grid, std::vector<std::uint32_t>& starts) {
    Tally tally;
    std::vector<std::uint32_t> scratch(2 * capacity);
    for (std::uint32_t p = 0; p < paths; ++p) WriteKeys{store, grid}(p, tally);
    for (std::uint32_t k = 0; k < capacity; ++k) PadKeys{store, grid.cells}(k, tally);
    radixSortPairs(keys.data(), slots.data(), scratch.data(), scratch.data() + capacity, capacity,
                   std::bit_width(grid.cells - 1), 2);
    OrderPhotons const order{{photons.data(), std::uint32_t(photons.size())},
                             {slots.data(), capacity},
                             {&state, 1},
                             {positions.data(), capacity},
                             {powers.data(), capacity}};
    for (std::uint32_t k = 0; k < capacity; ++k) order(k, tally);
    findCells(keys, state, starts, 4);
  }

  int misplaced(const PhotonGrid& grid, const std::vector<std::uint32_t>& starts) const {
    int wrong = 0;
    for (std::uint32_t c = 0; c < grid.cells; ++c)
      for (std::uint32_t k = starts[c]; k < starts[c + 1]; ++k) {
        wrong += grid.key(positions[k].p) != c || points.at(powers[k].path - 1) != positions[k].p;
        wrong += k > starts[c] && powers[k].path <= powers[k - 1].path;  // stable: by path, then deposit
      }
    return wrong;
  }

 private:
  void count(TestRandom& random) {
    for (std::uint32_t p = 0; p < paths; ++p) {
      std::uint32_t const n = random.below(8);
      counts[p] = {n, n > stripe ? n - stripe : 0, n > stripe ? 1u : 0u};
      offsets[p + 1] = offsets[p] + counts[p];
    }
    REQUIRE((total() < capacity && offsets[paths].tail < tails && offsets[paths].tail > 10));
    state.chunkPhotons = total();
  }

  void fill(TestRandom& random) {
    for (std::uint32_t p = 0; p < paths; ++p)
      for (std::uint32_t j = 0; j < counts[p].all; ++j) {
        std::uint32_t const slot = store.slotOf(p, j);
        CHECK(photons.at(slot).power.path == 0);  // no slot twice
        points.push_back(Vec3(random.inBox(1)));
        photons[slot] = {{points.back(), 0}, {Rgb(1.0f), std::uint32_t(points.size())}};
      }
  }
};

}  // namespace

TEST_CASE("the stages order the photons by cell, tails included, and leave the rest of the list out") {
  Stored stored;
  for (std::uint32_t table : {1u << 14, 8u}) {
    PhotonGrid grid;
    layOut(grid, Bounds{Vec3d(-1), Vec3d(1)}, 0.2, table);
    CHECK(grid.dense == (table == 1u << 14));
    std::vector<std::uint32_t> starts(grid.cells + 1, 12345);
    stored.bin(grid, starts);
    CHECK(starts.front() == 0);
    CHECK(starts.back() == stored.total());
    CHECK(stored.misplaced(grid, starts) == 0);
  }
}

TEST_CASE("a halted iteration orders no photons") {
  constexpr std::uint32_t capacity = 40, cells = 4;  // for photons that are more than that
  std::vector<DepositCount> counts(1, {2 * capacity, 0, 0}), offsets{{0, 0, 0}, {2 * capacity, 0, 0}};
  std::vector<std::uint32_t> keys(capacity, 0), slots(capacity, 0), starts(cells + 1, 12345);
  IterationState state;
  state.chunkPhotons = 2 * capacity;
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
  for (std::uint32_t k = 0; k < capacity; ++k)
    OrderPhotons{{}, {}, {&state, 1}, {}, {}, {}, {}}(k, tally);  // touches nothing
  findCells(keys, state, starts, 2);
  CHECK(starts == std::vector<std::uint32_t>(cells + 1, 0));
}

TEST_CASE("the starts of the cells are those of a count, whatever the batch") {
  TestRandom random(8);
  for (std::uint32_t cells : {1u, 2u, 7u, 64u, 1000u})
    for (std::uint32_t n : {0u, 1u, 5u, 300u, 5000u})
      for (int kind = 0; kind < 3; ++kind) {
        std::vector<std::uint32_t> keys(n), expected(cells + 1, 0);
        for (std::uint32_t& k : keys) k = kind == 0 ? random.below(cells) : kind == 1 ? cells - 1 : cells / 2;
        std::sort(keys.begin(), keys.end());
        for (std::uint32_t k : keys) ++expected[k + 1];
        std::partial_sum(expected.begin(), expected.end(), expected.begin());
        keys.resize(n + 10, cells - 1);  // what pads the list
        IterationState state;
        state.chunkPhotons = n;
        for (std::uint32_t batch : {1u, 2u, 4u, 1024u}) {
          std::vector<std::uint32_t> starts(cells + 1, 12345);
          findCells(keys, state, starts, batch);
          CHECK(starts == expected);
        }
      }
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
