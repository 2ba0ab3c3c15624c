// The kd-tree's cells as the viewer draws them.

#include "accel/kdtree/cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "accel/kdtree/builder/build.h"
#include "tests/scenes/geometry_scenes.h"

using namespace ropelight;

namespace {

double volumeOf(const float* bounds) {
  double volume = 1;
  for (int a = 0; a < 3; ++a) volume *= double(bounds[a + 3]) - double(bounds[a]);
  return volume;
}

bool contains(const KdCell& outer, const KdCell& inner) {
  for (int a = 0; a < 3; ++a)
    if (inner.bounds[a] < outer.bounds[a] || inner.bounds[a + 3] > outer.bounds[a + 3]) return false;
  return true;
}

/// Whether some cell of the level above holds it.
bool hasParent(const std::vector<KdCell>& cells, const KdCell& child) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const KdCell& c) { return c.depth == child.depth - 1 && !c.leaf && contains(c, child); });
}

double share(const KdTree& tree, const std::vector<KdCell>& cells) {
  double volume = 0;
  for (const KdCell& c : cells) volume += volumeOf(c.bounds);
  return volume / volumeOf(tree.bounds);
}

}  // namespace

TEST_CASE("the cells of a level fill the root, and each lies within one of the level above") {
  for (const GeometryScene& scene : geometryScenes()) {
    CAPTURE(scene.name);
    KdTree const tree = buildKdTree(scene.flat, KdConfig{});
    for (int depth : {0, 1, 4, 9}) {
      CAPTURE(depth);
      std::vector<KdCell> const all = cellLines(tree, depth, false), deepest = cellLines(tree, depth, true);
      REQUIRE(!all.empty());
      CHECK(all[0].depth == 0);
      CHECK(std::memcmp(all[0].bounds, tree.bounds, sizeof(tree.bounds)) == 0);
      CHECK(share(tree, deepest) == doctest::Approx(1).epsilon(1e-9));
      int orphans = 0, disorder = 0;
      for (std::size_t i = 1; i < all.size(); ++i) {
        orphans += !hasParent(all, all[i]);
        disorder += all[i].depth < all[i - 1].depth || all[i].depth > depth;
      }
      CHECK(orphans == 0);
      CHECK(disorder == 0);
      for (const KdCell& c : deepest) CHECK((c.leaf || c.depth == depth));
      CHECK(all.size() + 1 == 2 * deepest.size());  // a binary tree: leaves are inner nodes and one more
    }
  }
}

TEST_CASE("all cells of a tree are as many as its nodes, and its leaves' are theirs") {
  KdTree const tree = buildKdTree(mixedShapes(), KdConfig{});
  CHECK(cellLines(tree, 64, false, tree.nodes.size()).size() == tree.nodes.size());
  std::vector<KdCell> const leaves = cellLines(tree, 64, true);
  CHECK(leaves.size() == tree.leaves.size());
  std::size_t found = 0;
  for (const KdLeaf& leaf : tree.leaves)
    found += std::any_of(leaves.begin(), leaves.end(), [&](const KdCell& c) {
      return c.leaf && std::memcmp(c.bounds, leaf.bounds, sizeof(leaf.bounds)) == 0;
    });
  CHECK(found == tree.leaves.size());
}

TEST_CASE("too many cells are whole levels of them") {
  KdTree const tree = buildKdTree(mixedShapes(), KdConfig{});
  REQUIRE(tree.nodes.size() > 40);
  for (std::size_t most : {1u, 2u, 3u, 10u, 40u}) {
    CAPTURE(most);
    std::vector<KdCell> const all = cellLines(tree, 64, false, most), deepest = cellLines(tree, 64, true, most);
    CHECK(all.size() <= most);
    CHECK(deepest.size() <= most);
    CHECK(share(tree, deepest) == doctest::Approx(1).epsilon(1e-9));
    CHECK(all.size() == cellLines(tree, all.back().depth, false).size());
  }
  CHECK(cellLines(KdTree{}, 8, false).empty());
}
