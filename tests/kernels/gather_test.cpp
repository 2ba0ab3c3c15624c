// Density estimation: which photons count and what they add up to, against looking at every photon.

#include "render/kernels/gather.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenes/photon_cloud.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr Real radius = Real(0.3);

/// Flux of whole numbers: sums are exact in any order, and tell by which photons they are.
Rgb mark(TestRandom& random, std::uint32_t below) {
  return {float(random.below(below)), float(random.below(below)), float(random.below(below))};
}

/// Photons on a bumpy floor whose normal is `up`, some of them at the very same place. Their flux is a mark.
struct Floor {
  std::vector<PhotonPosition> positions;
  std::vector<PhotonPower> powers;
  Vec3 up;

  Floor(Vec3 n, int count, std::uint32_t seed) : up(n) {
    TestRandom random(seed);
    Frame const frame(n);
    for (int i = 0; i < count; ++i) {
      Vec3 p = frame.toWorld(Vec3(random.between(-0.6, 0.6), random.between(-0.6, 0.6), random.between(-0.08, 0.08)));
      if (i % 5 == 0 && i > 0) p = positions[random.below(positions.size())].p;
      bool const below = random.below(10) == 0;
      positions.push_back({p, packDirection(below ? -n : n)});
      powers.push_back({mark(random, 8192), 1 + random.below(6)});
    }
  }

  Bounds bounds() const {
    Bounds b;
    for (const PhotonPosition& p : positions) b.grow(Vec3d(p.p));
    return b;
  }
};

GatherPoint pointAt(Vec3 p, Vec3 n) {
  GatherPoint g{};
  g.p = p;
  g.n = n;
  g.packedNormal = packDirection(n);
  g.edges = 2;
  g.weight = Rgb(0.5f, 0.25f, 1);
  return g;
}

struct Counted {
  Real distance2;
  std::uint32_t photon;
  bool operator<(const Counted& o) const {
    return distance2 < o.distance2 || (distance2 == o.distance2 && photon < o.photon);
  }
};

/// All photons on the disc, nearest first.
std::vector<Counted> onDisc(const GatherView& view, const GatherPoint& g) {
  std::vector<Counted> list;
  for (std::uint32_t k = 0; k < view.grid.positions.size; ++k) {
    Real d;
    PhotonPosition const& photon = view.grid.positions[k];
    if (view.onDisc(g, photon, d) && view.counts(g, photon, view.grid.powers[k])) list.push_back({d, k});
  }
  std::sort(list.begin(), list.end());
  return list;
}

Rgb fluxOf(const GatherView& view, const std::vector<Counted>& list, std::size_t count) {
  Rgb flux(0.0f);
  for (std::size_t i = 0; i < count; ++i) flux += view.grid.powers[list[i].photon].flux;
  return flux;
}

Gathering nearestOf(const GatherView& view, const GatherPoint& g, int k) {
  std::vector<Counted> const list = onDisc(view, g);
  if (list.size() < std::size_t(k))
    return {fluxOf(view, list, list.size()), std::uint32_t(list.size()), square(radius)};
  return {fluxOf(view, list, std::size_t(k) - 1), std::uint32_t(k), list[std::size_t(k) - 1].distance2};
}

bool same(const Gathering& a, const Gathering& b) {
  return a.flux == b.flux && a.count == b.count && a.radius2 == b.radius2;
}

struct Pile {
  const char* name;
  std::vector<PhotonPosition> positions;
};

/// Photons on planes z = const, the first and the middle one being where something happens.
std::vector<Pile> piles() {
  TestRandom random(9);
  std::uint32_t const up = packDirection(Vec3(0, 0, 1));
  std::vector<Pile> list{
      {"thousands at one place, some beside it", {}}, {"rings at a few distances", {}}, {"distances that halve", {}},
      {"a dense cluster in a sparse disc", {}},       {"a million away", {}},           {"neighbouring floats", {}}};
  for (int i = 0; i < 4000; ++i) {
    double const angle = random.between(0, 2 * M_PI), x = random.between(-0.3, 0.3), y = random.between(-0.3, 0.3);
    list[0].positions.push_back({i < 40 ? Vec3(x, y, 0) : Vec3(0.1f, 0, 0), up});
    Real const side = i % 4 < 2 ? Real(1) : Real(-1), ring = Real(0.01) * Real(1 + i / 4 % 5);
    list[1].positions.push_back({i == 0 ? Vec3(0) : i % 2 ? Vec3(side * ring, 0, 0) : Vec3(0, side * ring, 0), up});
    double const r = 0.3 * std::pow(0.5, i % 60);
    list[2].positions.push_back({i == 0 ? Vec3(0) : Vec3(r * std::cos(angle), r * std::sin(angle), 0), up});
    double const shrink = i % 8 == 1 ? 1 : 1e-4;
    list[3].positions.push_back({Vec3(shrink * x, shrink * y, 0), up});
    list[4].positions.push_back({Vec3(Vec3d(1e6 + x, -1e6 + y, 1e6)), up});
    list[5].positions.push_back({Vec3(i == 0 ? 0.0f : 0.1f + float(i % 300) * 7.4505806e-9f, 0, 0), up});
  }
  return list;
}

template <class Gather>
Rgb gathered(const Gather& gather) {
  Tally tally;
  gather(0, tally);
  return gather.radiance[0];
}

/// Calls visit(view, point) for floors of many directions, grids of many cells, and points on, above and beside them.
template <class Visit>
void forEveryGather(Visit&& visit) {
  TestRandom random(1);
  for (Vec3 n : {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(glm::normalize(Vec3d(1, 1, 1))), Vec3(random.direction())}) {
    Floor const floor(n, 2500, random.word());
    for (double cells : {0.5, 1.0, 1.3, 4.0})
      for (std::uint32_t table : {1u << 20, 32u}) {
        PhotonCloud const cloud(floor.positions, floor.powers, floor.bounds(), cells * double(radius), table);
        GatherView const view{cloud.grid, radius, 6};
        Frame const frame(n);
        for (int i = 0; i < 40; ++i)
          visit(view, pointAt(frame.toWorld(Vec3(random.between(-0.9, 0.9), random.between(-0.9, 0.9),
                                                 random.between(-0.1, 0.1))),
                              n));
      }
  }
}

}  // namespace

TEST_CASE("the radius gather sums every photon on its disc, whatever the cells") {
  int wrong = 0;
  std::size_t photons = 0;
  forEveryGather([&](const GatherView& view, const GatherPoint& g) {
    Rgb radiance(0.0f);
    std::vector<Counted> const list = onDisc(view, g);
    Rgb const expected = g.weight * fluxOf(view, list, list.size()) * float(invPi / square(radius));
    wrong += gathered(GatherRadius{view, {&g, 1}, {&radiance, 1}}) != expected;
    wrong += gatherDisc(view, g).count != list.size();
    photons += list.size();
  });
  CHECK(wrong == 0);
  CHECK(photons > 10000);
}

TEST_CASE("the k-nearest gather takes the nearest, ties by photon, and leaves the farthest out of the sum") {
  for (int k : {2, 3, 10, 50, nearestLimit}) {
    CAPTURE(k);
    int wrong = 0, full = 0, short_ = 0;
    forEveryGather([&](const GatherView& view, const GatherPoint& g) {
      Rgb radiance(0.0f);
      Gathering const expected = nearestOf(view, g, k);
      wrong += !same(gatherNearest(view, g, k), expected);
      putGathering(radiance, g, expected, Gathered::radiance);
      wrong += gathered(GatherNearest{view, k, {&g, 1}, {&radiance, 1}}) != Real(2) * radiance;
      ++(expected.count == std::uint32_t(k) ? full : short_);
    });
    CHECK(wrong == 0);
    CHECK(full > 20);
    CHECK(short_ > 20);
  }
}

TEST_CASE("the k nearest are found among photons that lie as unevenly as can be") {
  Vec3 const up(0, 0, 1);
  TestRandom random(10);
  for (const Pile& pile : piles()) {
    CAPTURE(pile.name);
    std::vector<PhotonPower> powers;
    for (std::size_t i = 0; i < pile.positions.size(); ++i) powers.push_back({mark(random, 4096), 1});
    Bounds bounds;
    for (const PhotonPosition& p : pile.positions) bounds.grow(Vec3d(p.p));
    for (double cells : {0.5, 1.0, 5.0})
      for (std::uint32_t table : {1u << 16, 16u}) {
        PhotonCloud const cloud(pile.positions, powers, bounds, cells * double(radius), table);
        GatherView const view{cloud.grid, radius, 1024};
        for (int k : {1, 2, 16, 17, 50, 127, nearestLimit}) {
          CAPTURE(k);
          for (std::size_t i : {std::size_t(0), pile.positions.size() / 2}) {
            GatherPoint const g = pointAt(pile.positions[i].p, up);
            CHECK(same(gatherNearest(view, g, k), nearestOf(view, g, k)));
          }
        }
      }
  }
}

TEST_CASE("a photon at the rim of a tilted disc counts wherever the borders of the cells fall") {
  // The corner of the disc's profile that reaches farthest along x: √(1 + 0.2²) radii at a slope of 0.2.
  Vec3 const n = glm::normalize(Vec3(0.2f, 0, 1)), u = glm::normalize(Vec3(1, 0, -0.2f));
  Vec3 const rim = radius * (0.999f * u + 0.999f * discThickness * n);
  for (double cells : {0.5, 1.0, 4.0}) {
    int missed = 0;
    for (int i = 0; i < 1000; ++i)
      for (Real side : {Real(1), Real(-1)}) {
        GatherPoint const g = pointAt(Vec3(0.001f * Real(i), 0, 0), n);
        PhotonCloud const cloud({{g.p + side * rim, g.packedNormal}}, {{Rgb(1.0f), 1}}, Bounds{Vec3d(-2), Vec3d(2)},
                                cells * double(radius), 1 << 14);
        Rgb radiance(0.0f);
        missed += gathered(GatherRadius{{cloud.grid, radius, 6}, {&g, 1}, {&radiance, 1}}) == Rgb(0.0f);
      }
    CHECK(missed == 0);
  }
}

TEST_CASE("photons at the gather point itself divide by no area") {
  std::vector<PhotonPosition> const positions(8, {Vec3(0.1f), packDirection(Vec3(0, 0, 1))});
  std::vector<PhotonPower> const powers(8, {Rgb(1.0f), 1});
  PhotonCloud const cloud(positions, powers, Bounds{Vec3d(0), Vec3d(1)}, 0.3, 1024);
  GatherPoint const g = pointAt(Vec3(0.1f), Vec3(0, 0, 1));
  Rgb radiance(0.0f);
  CHECK(gathered(GatherNearest{{cloud.grid, radius, 1024}, 4, {&g, 1}, {&radiance, 1}}) == Rgb(0.0f));
}

TEST_CASE("a photon counts within the disc, on the gather point's side, on a path that is short enough") {
  Vec3 const up(0, 0, 1);
  struct Case {
    Vec3 p, n;
    std::uint32_t edges;
    bool counts;
  };
  Vec3 const tilted = glm::normalize(Vec3(1, 0, 0.2f)), steep = glm::normalize(Vec3(1, 0, 0.05f));
  for (const Case& c :
       {Case{{0, 0, 0}, up, 4, true}, Case{{0.29f, 0, 0}, up, 4, true}, Case{{0.31f, 0, 0}, up, 4, false},
        Case{{0.25f, 0.25f, 0}, up, 4, false}, Case{{0, 0.29f, 0.05f}, up, 4, true}, Case{{0, 0, -0.05f}, up, 4, true},
        Case{{0, 0, 0.07f}, up, 4, false}, Case{{0, 0, 0}, -up, 4, false}, Case{{0, 0, 0}, tilted, 4, true},
        Case{{0, 0, 0}, steep, 4, false}, Case{{0, 0, 0}, up, 5, false}}) {
    CAPTURE(c.p.x);
    CAPTURE(c.p.z);
    PhotonCloud const cloud({{c.p, packDirection(c.n)}}, {{Rgb(1.0f), c.edges}}, Bounds{Vec3d(-1), Vec3d(1)}, 0.3,
                            1024);
    GatherPoint const g = pointAt(Vec3(0), up);
    Rgb radiance(0.0f);
    Rgb const sum = gathered(GatherRadius{{cloud.grid, radius, 6}, {&g, 1}, {&radiance, 1}});
    CHECK((sum != Rgb(0.0f)) == c.counts);
    if (c.counts) CHECK(sum.z == doctest::Approx(1 / (M_PI * 0.09)));
  }
}

TEST_CASE("what a gather finds is added to what was there, and a black point gathers nothing") {
  PhotonCloud const cloud({{Vec3(0), packDirection(Vec3(0, 0, 1))}}, {{Rgb(1.0f), 1}}, Bounds{Vec3d(-1), Vec3d(1)}, 0.3,
                          1024);
  GatherPoint g = pointAt(Vec3(0), Vec3(0, 0, 1));
  Rgb radiance(7.0f);
  CHECK(gathered(GatherRadius{{cloud.grid, radius, 6}, {&g, 1}, {&radiance, 1}}).z > 7);
  g.weight = Rgb(0.0f);
  radiance = Rgb(7.0f);
  CHECK(gathered(GatherRadius{{cloud.grid, radius, 6}, {&g, 1}, {&radiance, 1}}) == Rgb(7.0f));
  CHECK(gathered(GatherNearest{{cloud.grid, radius, 6}, 2, {&g, 1}, {&radiance, 1}}) == Rgb(7.0f));
}
