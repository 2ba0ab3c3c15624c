// The hierarchy's builders: what every hierarchy must be, whatever the scene.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>

#include "tests/scenes/bvh_scenes.h"

using namespace ropelight;

namespace {

/// Walks a whole hierarchy and counts what is wrong with it.
template <int W>
struct Inspection {
  const Bvh<W>& bvh;
  const FlatScene& flat;
  double pad;
  int depth = 0, outside = 0, unsorted = 0, empty = 0;
  std::uint64_t leaves = 0, nodes = 0;
  double cost = 0;
  std::vector<int> timesHeld, timesStored;

  Inspection(const Bvh<W>& b, const FlatScene& f)
      : bvh(b), flat(f), pad(std::ldexp(f.reach, -20)), timesHeld(f.primitiveCount()), timesStored(f.primitiveCount()) {
    for (std::uint32_t id : bvh.items) ++timesStored.at(id);
    visit(0, 1);
  }

  Bounds visit(std::uint32_t index, int level) {
    const BvhNode<W>& node = bvh.nodes.at(index);
    depth = std::max(depth, level);
    ++nodes;
    Bounds all;
    for (int k = 0; k < W; ++k) {
      if (node.child[k].none()) {
        empty += W == 2 || !(node.min[0][k] > node.max[0][k]);
        continue;
      }
      Bounds box;
      for (int a = 0; a < 3; ++a) {
        box.min[a] = double(node.min[a][k]);
        box.max[a] = double(node.max[a][k]);
      }
      Bounds const inside = node.child[k].isLeaf() ? leaf(node.child[k], box) : visit(node.child[k].index(), level + 1);
      for (int a = 0; a < 3; ++a) outside += !(inside.min[a] >= box.min[a] && inside.max[a] <= box.max[a]);
      all.grow(box);
    }
    cost += all.area();
    rootArea = all.area();  // the root is visited last
    return all;
  }

  Bounds leaf(BvhChild child, const Bounds& box) {
    ++leaves;
    cost += box.area() * child.count();
    Bounds padded;
    for (std::uint32_t i = child.index(); i < child.index() + child.count(); ++i) {
      std::uint32_t const id = bvh.items.at(i);
      ++timesHeld[id];
      unsorted += i > child.index() && bvh.items[i - 1] >= id;
      padded.grow(flat.primitiveBounds(id));
    }
    padded.min -= pad;
    padded.max += pad;
    return padded;
  }

  double rootArea = 0;
};

template <int W>
void checkHierarchy(const Bvh<W>& bvh, const FlatScene& flat, int leafSize) {
  Inspection<W> const found(bvh, flat);
  bool const single = flat.primitiveCount() == 1;
  for (std::uint32_t id = 0; id < flat.primitiveCount(); ++id) {
    REQUIRE(found.timesStored[id] == 1);
    REQUIRE(found.timesHeld[id] == (single ? 2 : 1));
  }
  CHECK(found.outside == 0);
  CHECK(found.unsorted == 0);
  CHECK(found.empty == 0);
  CHECK(found.nodes == bvh.nodes.size());
  CHECK(found.leaves == bvh.stats.leaves);
  CHECK(found.depth == bvh.stats.depth);
  CHECK(found.depth <= bvhDepthLimit);
  CHECK(found.leaves * std::uint64_t(leafSize) >= flat.primitiveCount());
}

Bounds boundsOf(const FlatScene& flat, std::span<const std::uint32_t> ids) {
  Bounds all;
  for (std::uint32_t id : ids) all.grow(flat.primitiveBounds(id));
  return all;
}

/// Of halving down to leaves of 4, in areas.
double halvingCost(const FlatScene& flat, std::span<std::uint32_t> ids) {
  Bounds const all = boundsOf(flat, ids);
  if (ids.size() <= 4) return all.area() * double(ids.size());
  Vec3d const e = all.extent();
  int const axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  std::ranges::sort(ids, {}, [&](std::uint32_t id) {
    Bounds const b = flat.primitiveBounds(id);
    return b.min[axis] + b.max[axis];
  });
  std::size_t const half = ids.size() / 2;
  return all.area() + halvingCost(flat, ids.first(half)) + halvingCost(flat, ids.subspan(half));
}

template <int W>
bool identical(const Bvh<W>& a, const Bvh<W>& b) {
  return a.items == b.items && a.nodes.size() == b.nodes.size() && a.stats.sahCost == b.stats.sahCost &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(BvhNode<W>)) == 0;
}

}  // namespace

TEST_CASE("a hierarchy holds every primitive once, within padded bounds and the depth limit") {
  for (const GeometryScene& scene : bvhScenes()) {
    CAPTURE(scene.name);
    for (const NamedConfig& c : bvhConfigs()) {
      CAPTURE(c.name);
      Bvh<2> const binary = buildBvh(scene.flat, c.config);
      checkHierarchy(binary, scene.flat, c.config.leafSize);
      CHECK((binary.nodes.size() == 1 || binary.nodes.size() < scene.flat.primitiveCount()));
      Bvh<4> const wide = widen(binary);
      checkHierarchy(wide, scene.flat, c.config.leafSize);
      CHECK(wide.items == binary.items);
    }
  }
}

TEST_CASE("the cost that a hierarchy reports is that of its boxes") {
  for (const GeometryScene& scene : geometryScenes()) {
    if (scene.flat.primitiveCount() < 10) continue;
    CAPTURE(scene.name);
    Bvh<2> const binary = buildBvh(scene.flat, BvhConfig{});
    Inspection<2> const two(binary, scene.flat);
    CHECK(binary.stats.sahCost == doctest::Approx(two.cost / two.rootArea).epsilon(1e-5));
    Bvh<4> const wide = widen(binary);
    Inspection<4> const four(wide, scene.flat);
    CHECK(wide.stats.sahCost == doctest::Approx(four.cost / four.rootArea).epsilon(1e-5));
    CHECK(wide.stats.sahCost <= binary.stats.sahCost);
  }
}

TEST_CASE("the sweep costs no more than bins, and reinsertion no more than the sweep") {
  for (const GeometryScene& scene : geometryScenes()) {
    if (scene.flat.primitiveCount() < 10) continue;
    CAPTURE(scene.name);
    double const bins = buildBvh(scene.flat, {.sweep = false, .bins = 16}).stats.sahCost;
    double const sweep = buildBvh(scene.flat, {}).stats.sahCost;
    CHECK(sweep <= 1.05 * bins);
    CHECK(buildBvh(scene.flat, {.reinsertion = 3}).stats.sahCost <= 1.01 * sweep);
  }
}

TEST_CASE("a hierarchy costs less than halving along the longest side") {
  FlatScene const flat = triangleScene(bumpyBall(50, 51));
  std::vector<std::uint32_t> ids(flat.primitiveCount());
  std::iota(ids.begin(), ids.end(), 0u);
  CHECK(buildBvh(flat, {}).stats.sahCost < 0.8 * halvingCost(flat, ids) / boundsOf(flat, ids).area());
}

TEST_CASE("leaves are worth their primitives") {
  FlatScene const flat = triangleScene(bumpyBall(50, 51));
  CHECK(buildBvh(flat, {.leafSize = 1}).stats.leaves == flat.primitiveCount());
  double cost = std::numeric_limits<double>::infinity();
  for (int size : {1, 2, 4, 8, 15}) {
    double const c = buildBvh(flat, {.leafSize = size}).stats.sahCost;
    CHECK(c <= cost);
    cost = c;
  }
}

TEST_CASE("the same hierarchy from any number of threads") {
  std::vector<FlatTriangle> const ball = bumpyBall(100, 101);
  for (const NamedConfig& c : bvhConfigs()) {
    CAPTURE(c.name);
    for (const FlatScene& flat : {triangleScene(ball), mixedShapes()}) {
      BvhConfig config = c.config;
      config.threads = 1;
      Bvh<2> const reference = buildBvh(flat, config);
      for (int threads : {2, 3}) {
        config.threads = threads;
        CHECK(identical(buildBvh(flat, config), reference));
      }
    }
  }
}

TEST_CASE("10⁵ coincident triangles make a shallow tree") {
  FlatScene const flat = triangleScene(std::vector<FlatTriangle>(100000, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}));
  for (bool sweep : {false, true}) {
    Bvh<2> const bvh = buildBvh(flat, {.sweep = sweep});
    CHECK(bvh.stats.depth <= 17);
    CHECK(bvh.nodes.size() < flat.primitiveCount());
  }
}
