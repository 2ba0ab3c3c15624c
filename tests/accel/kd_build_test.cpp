// How the kd-tree's builders choose, and that what they make is bounded and the same for any number of threads.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "accel/kdtree/builder/build.h"
#include "accel/kdtree/builder/clip.h"
#include "render/flatten/flatten.h"
#include "tests/scenes/geometry_scenes.h"

using namespace ropelight;

namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const KdTree& a, const KdTree& b) {
  return sameBytes(a.nodes, b.nodes) && sameBytes(a.leaves, b.leaves) && sameBytes(a.references, b.references) &&
         std::equal(a.bounds, a.bounds + 6, b.bounds) && a.stats.sahCost == b.stats.sahCost &&
         a.stats.depth == b.stats.depth && a.stats.budgetHits == b.stats.budgetHits;
}

double areaOf(const float* bounds) {
  double e[3];
  for (int a = 0; a < 3; ++a) e[a] = double(bounds[a + 3]) - double(bounds[a]);
  return 2 * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
}

/// Expected cost of a split of the whole scene, from the definition: primitives whose padded bounds reach a side.
double rootCost(const FlatScene& flat, const KdTree& tree, const KdConfig& config, int axis, float s) {
  double const padding = KdClipper(flat, true).padding();
  int low = 0, high = 0;
  for (std::uint32_t i = 0; i < flat.primitiveCount(); ++i) {
    Bounds const b = flat.primitiveBounds(i);
    low += b.min[axis] - padding <= double(s);
    high += b.max[axis] + padding >= double(s);
  }
  float half[2][6];
  for (auto& h : half) std::copy_n(tree.bounds, 6, h);
  half[0][axis + 3] = half[1][axis] = s;
  double const tests = (areaOf(half[0]) * low + areaOf(half[1]) * high) / areaOf(tree.bounds);
  return config.traversalCost + tests * (low == 0 || high == 0 ? 1 - config.emptyBonus : 1);
}

/// The least cost over the floats at and next to the ends of every primitive's padded bounds.
double leastRootCost(const FlatScene& flat, const KdTree& tree, const KdConfig& config) {
  double const padding = KdClipper(flat, true).padding();
  double least = 1e300;
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint32_t i = 0; i < flat.primitiveCount(); ++i) {
      Bounds const b = flat.primitiveBounds(i);
      for (double end : {b.min[axis] - padding, b.max[axis] + padding}) {
        float s = std::nextafter(std::nextafter(float(end), -INFINITY), -INFINITY);
        for (int k = 0; k < 5; ++k, s = std::nextafter(s, INFINITY))
          if (s > tree.bounds[axis] && s < tree.bounds[axis + 3])
            least = std::min(least, rootCost(flat, tree, config, axis, s));
      }
    }
  return least;
}

KdConfig with(KdSplit split, bool clip) {
  KdConfig c;
  c.split = split;
  c.clip = clip;
  return c;
}

std::vector<KdConfig> allBuilders() {
  std::vector<KdConfig> all;
  for (KdSplit split : {KdSplit::sah, KdSplit::sweep, KdSplit::midpoint})
    for (bool clip : {true, false}) all.push_back(with(split, clip));
  return all;
}

FlatScene smallCloud(std::uint32_t seed, int count) {
  TestRandom random(seed);
  return flatten(SceneBuilder().mesh(randomTriangles(random, count, 0.1)).scene);
}

/// Whether an axis separates a triangle from a leaf's cell grown by `slack` (Akenine-Möller 2001).
bool apart(const FlatTriangle& t, const KdLeaf& leaf, double slack) {
  Vec3d const lo(leaf.bounds[0], leaf.bounds[1], leaf.bounds[2]), hi(leaf.bounds[3], leaf.bounds[4], leaf.bounds[5]);
  Vec3d const center = 0.5 * (lo + hi), half = 0.5 * (hi - lo) + slack;
  Vec3d const v[3] = {t.a - center, t.b - center, t.c - center};
  std::vector<Vec3d> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, glm::cross(v[1] - v[0], v[2] - v[0])};
  for (int e = 0; e < 3; ++e)
    for (int a = 0; a < 3; ++a) axes.push_back(glm::cross(v[(e + 1) % 3] - v[e], axes[std::size_t(a)]));
  return std::any_of(axes.begin(), axes.end(), [&](Vec3d axis) {
    auto const [least, most] = std::minmax({glm::dot(axis, v[0]), glm::dot(axis, v[1]), glm::dot(axis, v[2])});
    double const reach = glm::dot(glm::abs(axis), half);
    return least > reach || most < -reach;
  });
}

/// Sums the cost of the tree anew, from its leaves' bounds.
double costOf(const KdTree& tree, const KdConfig& config, std::uint32_t node, const float* bounds) {
  const KdNode& n = tree.nodes[node];
  if (n.isLeaf()) return areaOf(bounds) * tree.leaves[n.target()].count;
  float low[6], high[6];
  std::copy_n(bounds, 6, low);
  std::copy_n(bounds, 6, high);
  low[n.axis() + 3] = high[n.axis()] = n.split;
  return config.traversalCost * areaOf(bounds) + costOf(tree, config, node + 1, low) +
         costOf(tree, config, n.target(), high);
}

}  // namespace

TEST_CASE("the sweep splits the root where no other plane is expected to cost less") {
  for (int count : {20, 100, 300}) {  // by trying all, by sorted events, and among many
    CAPTURE(count);
    FlatScene const flat = smallCloud(41, count);
    KdConfig const config = with(KdSplit::sweep, true);
    KdTree const tree = buildKdTree(flat, config);
    const KdNode& root = tree.nodes[0];
    REQUIRE_FALSE(root.isLeaf());
    double const chosen = rootCost(flat, tree, config, int(root.axis()), root.split);
    CHECK(chosen == doctest::Approx(leastRootCost(flat, tree, config)).epsilon(1e-12));
    KdTree const binned = buildKdTree(flat, with(KdSplit::sah, true));
    const KdNode& other = binned.nodes[0];
    REQUIRE_FALSE(other.isLeaf());
    CHECK(chosen <= rootCost(flat, binned, config, int(other.axis()), other.split) * (1 + 1e-12));
  }
}

TEST_CASE("midpoint splits halve the longest side") {
  KdTree const tree = buildKdTree(smallCloud(42, 50), with(KdSplit::midpoint, true));
  int longest = 0;
  auto const extent = [&](int a) { return tree.bounds[a + 3] - tree.bounds[a]; };
  for (int a = 1; a < 3; ++a)
    if (extent(a) > extent(longest)) longest = a;
  CHECK(int(tree.nodes[0].axis()) == longest);
  CHECK(tree.nodes[0].split == doctest::Approx(0.5 * (tree.bounds[longest] + tree.bounds[longest + 3])));
}

TEST_CASE("the tree is the same for any number of threads") {
  FlatScene const ball = flatten(SceneBuilder().mesh(bumpyBall(70, 61)).scene);  // enough for several threads to share
  for (KdSplit split : {KdSplit::sah, KdSplit::sweep, KdSplit::midpoint}) {
    KdConfig config = with(split, true);
    config.threads = 1;
    KdTree const one = buildKdTree(ball, config);
    CHECK(one.leaves.size() > 1000);
    config.threads = 3;
    CHECK(same(one, buildKdTree(ball, config)));
  }
  KdConfig config;
  CHECK(same(buildKdTree(mixedShapes(), config), buildKdTree(mixedShapes(), config)));
}

TEST_CASE("settings differ where trees do, and not by threads") {
  KdConfig a, b;
  b.threads = 7;
  CHECK(a == b);
  b.clip = !a.clip;
  CHECK_FALSE(a == b);
}

TEST_CASE("clipped primitives are in fewer cells, and the tree costs less") {
  FlatScene const ball = flatten(SceneBuilder().mesh(bumpyBall(60, 61)).scene), sticks = needles(300);
  for (KdSplit split : {KdSplit::sah, KdSplit::sweep, KdSplit::midpoint})
    for (const FlatScene* flat : {&ball, &sticks}) {
      KdTree const clipped = buildKdTree(*flat, with(split, true)), whole = buildKdTree(*flat, with(split, false));
      CHECK(clipped.stats.sahCost < 0.95 * whole.stats.sahCost);
    }
}

TEST_CASE("clipped, a leaf holds only triangles that come near it") {
  FlatScene const flat = needles(300);
  double const slack = 4 * KdClipper(flat, true).padding();
  auto const strangers = [&](const KdTree& tree) {
    int count = 0;
    for (const KdLeaf& leaf : tree.leaves)
      for (std::uint32_t k = 0; k < leaf.count; ++k)
        count += apart(flat.triangles[tree.references[leaf.first + k]], leaf, slack);
    return count;
  };
  CHECK(strangers(buildKdTree(flat, with(KdSplit::sah, true))) == 0);
  CHECK(strangers(buildKdTree(flat, with(KdSplit::sah, false))) > 0);
}

TEST_CASE("statistics are those of the tree") {
  for (const KdConfig& config : allBuilders()) {
    FlatScene const flat = mixedShapes();
    KdTree const tree = buildKdTree(flat, config);
    const KdTreeStats& s = tree.stats;
    CHECK(s.sahCost == doctest::Approx(costOf(tree, config, 0, tree.bounds) / areaOf(tree.bounds)));
    CHECK(tree.nodes.size() == 2 * tree.leaves.size() - 1);
    CHECK(s.duplicates == doctest::Approx(double(tree.references.size()) / flat.primitiveCount()));
    std::uint32_t largest = 0;
    for (const KdLeaf& leaf : tree.leaves) largest = std::max(largest, leaf.count);
    CHECK(s.largestLeaf == largest);
  }
}

TEST_CASE("a tree of the heuristic never costs more than one leaf") {
  for (const GeometryScene& scene : geometryScenes())
    for (const KdConfig& config : allBuilders()) {
      if (config.split == KdSplit::midpoint) continue;
      CAPTURE(scene.name);
      CHECK(buildKdTree(scene.flat, config).stats.sahCost <= scene.flat.primitiveCount() * (1 + 1e-12));
    }
}

TEST_CASE("no scene makes more leaves or references than the budget") {
  std::vector<GeometryScene> scenes = geometryScenes();
  scenes.push_back({"1000 needles", needles(1000)});
  scenes.push_back({"3000 coincident triangles", coincidentTriangles(3000)});
  scenes.push_back({"3000 in one point", onePoint(3000, {1, 2, 3})});
  std::uint64_t hits = 0;
  for (const GeometryScene& scene : scenes)
    for (KdSplit split : {KdSplit::sah, KdSplit::sweep, KdSplit::midpoint}) {
      CAPTURE(scene.name);
      KdConfig config = with(split, split != KdSplit::midpoint);
      config.leafSize = 1;
      config.maxDepth = 40;
      config.badSplits = 1000;
      KdTree const tree = buildKdTree(scene.flat, config);
      CHECK(tree.leaves.size() <= kdTreeBudget(scene.flat.primitiveCount()));
      CHECK(tree.references.size() <= kdTreeBudget(scene.flat.primitiveCount()));
      CHECK(tree.stats.depth <= 40);
      hits += tree.stats.budgetHits;
    }
  CHECK(hits > 0);
  CHECK(kdTreeBudget(0) == 64);
  CHECK(kdTreeBudget(1000) == 16064);
  CHECK(kdTreeBudget(0xFFFFFFFFu) == std::uint64_t(1) << 29);
}

TEST_CASE("one hundred thousand coincident triangles end in few leaves" * doctest::test_suite("slow")) {
  constexpr int count = 100000;
  FlatScene const flat = coincidentTriangles(count);
  for (const KdConfig& config : allBuilders()) {
    KdTree const tree = buildKdTree(flat, config);
    CHECK(tree.references.size() <= 8 * count);
    CHECK(tree.stats.largestLeaf == count);
    CHECK(tree.leaves.size() < 100);
  }
}
