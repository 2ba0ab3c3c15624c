// The kd-tree as a structure: cells, ropes and references.

#include <doctest/doctest.h>

#include <algorithm>

#include "accel/kdtree/traverse_ropes.h"
#include "tests/scenes/geometry_scenes.h"

using namespace ropelight;

namespace {

struct Cell {
  float bounds[6];
};

/// The bounds of every node, from the split planes alone.
std::vector<Cell> cellsOf(const KdTree& tree) {
  std::vector<Cell> cells(tree.nodes.size());
  std::copy_n(tree.bounds, 6, cells[0].bounds);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const KdNode& node = tree.nodes[n];
    if (node.isLeaf()) continue;
    cells[n + 1] = cells[node.target()] = cells[n];
    cells[n + 1].bounds[node.axis() + 3] = cells[node.target()].bounds[node.axis()] = node.split;
  }
  return cells;
}

/// Whether a cell lies against a leaf's face on the other side and covers all of it.
bool covers(const Cell& cell, const KdLeaf& leaf, int face) {
  int const axis = face % 3;
  if (cell.bounds[face < 3 ? axis + 3 : axis] != leaf.bounds[face]) return false;
  for (int a = 0; a < 3; ++a)
    if (a != axis && (cell.bounds[a] > leaf.bounds[a] || cell.bounds[a + 3] < leaf.bounds[a + 3])) return false;
  return true;
}

/// The leaves whose cells, grown by `slack`, hold p.
void leavesAt(const KdTree& tree, std::uint32_t n, Vec3d p, double slack, std::vector<const KdLeaf*>& out) {
  const KdNode& node = tree.nodes[n];
  if (node.isLeaf()) return out.push_back(&tree.leaves[node.target()]);
  double const distance = p[int(node.axis())] - double(node.split);
  if (distance <= slack) leavesAt(tree, n + 1, p, slack, out);
  if (distance >= -slack) leavesAt(tree, node.target(), p, slack, out);
}

bool holds(const KdTree& tree, const KdLeaf& leaf, std::uint32_t primitive) {
  auto const first = tree.references.begin() + leaf.first;
  return std::binary_search(first, first + leaf.count, primitive);
}

template <class T>
Span<const T> spanOf(const std::vector<T>& v) {
  return {v.data(), std::uint32_t(v.size())};
}

KdTreeView viewOf(const KdTree& tree) {
  KdTreeView view{spanOf(tree.nodes), spanOf(tree.leaves), spanOf(tree.references)};
  std::copy_n(tree.bounds, 6, view.bounds);
  return view;
}

struct BuiltTree {
  std::string scene, builder;
  KdConfig config;
  FlatScene flat;
  KdTree tree;
};

/// Every scene by every builder, made once.
const std::vector<BuiltTree>& builtTrees() {
  static std::vector<BuiltTree> const trees = [] {
    std::vector<BuiltTree> all;
    for (const GeometryScene& scene : geometryScenes())
      for (const TreeConfig& c : treeConfigs())
        all.push_back({scene.name, c.name, c.config, scene.flat, buildKdTree(scene.flat, c.config)});
    return all;
  }();
  return trees;
}

template <class Visit>
void forEveryTree(Visit&& visit) {
  for (const BuiltTree& built : builtTrees()) {
    CAPTURE(built.scene);
    CAPTURE(built.builder);
    visit(built.flat, built.config, built.tree);
  }
}

}  // namespace

TEST_CASE("the cells of the leaves are those of the splits and fill the tree's bounds") {
  forEveryTree([](const FlatScene& flat, const KdConfig& config, const KdTree& tree) {
    std::vector<Cell> const cells = cellsOf(tree);
    int wrong = 0, depthLimit = config.maxDepth;
    std::size_t leaves = 0;
    double volume = 0;
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      if (!tree.nodes[n].isLeaf()) continue;
      ++leaves;
      const KdLeaf& leaf = tree.leaves.at(tree.nodes[n].target());
      double v = 1;
      for (int a = 0; a < 3; ++a) {
        wrong += leaf.bounds[a] != cells[n].bounds[a] || leaf.bounds[a + 3] != cells[n].bounds[a + 3];
        wrong += !(leaf.bounds[a] < leaf.bounds[a + 3]);
        v *= double(leaf.bounds[a + 3]) - double(leaf.bounds[a]);
      }
      volume += v;
    }
    double whole = 1;
    for (int a = 0; a < 3; ++a) {
      whole *= double(tree.bounds[a + 3]) - double(tree.bounds[a]);
      if (flat.primitiveCount() > 0)
        wrong += double(tree.bounds[a]) > flat.bounds.min[a] || double(tree.bounds[a + 3]) < flat.bounds.max[a];
    }
    CHECK(wrong == 0);
    CHECK(leaves == tree.leaves.size());
    CHECK(volume / whole == doctest::Approx(1).epsilon(1e-9));
    if (depthLimit > 0) CHECK(tree.stats.depth <= depthLimit);
  });
}

TEST_CASE("each rope leads to the smallest node that covers its face, or out of the tree") {
  forEveryTree([](const FlatScene&, const KdConfig&, const KdTree& tree) {
    std::vector<Cell> const cells = cellsOf(tree);
    int missing = 0, uncovered = 0, loose = 0;
    for (const KdLeaf& leaf : tree.leaves)
      for (int f = 0; f < 6; ++f) {
        std::uint32_t const rope = leaf.ropes[f];
        missing += (rope == noRope) != (leaf.bounds[f] == tree.bounds[f]);
        if (rope == noRope) continue;
        uncovered += !covers(cells.at(rope), leaf, f);
        const KdNode& node = tree.nodes[rope];
        loose += !node.isLeaf() && (covers(cells[rope + 1], leaf, f) || covers(cells[node.target()], leaf, f));
      }
    CHECK(missing == 0);
    CHECK(uncovered == 0);
    CHECK(loose == 0);
  });
}

TEST_CASE("references are ascending in each leaf and every primitive is somewhere") {
  forEveryTree([](const FlatScene& flat, const KdConfig& config, const KdTree& tree) {
    std::vector<bool> seen(flat.primitiveCount(), false);
    int disorder = 0;
    std::size_t references = 0;
    for (const KdLeaf& leaf : tree.leaves) {
      references += leaf.count;
      for (std::uint32_t k = 0; k < leaf.count; ++k) {
        std::uint32_t const p = tree.references.at(leaf.first + k);
        seen.at(p) = true;
        disorder += k > 0 && tree.references[leaf.first + k - 1] >= p;
      }
    }
    CHECK(disorder == 0);
    CHECK(references == tree.references.size());
    CHECK(std::count(seen.begin(), seen.end(), false) == 0);
    bool const apart = flat.primitiveCount() > 100 && flat.primitiveBounds(0).area() < flat.bounds.area();
    if (apart && config.leafSize <= 16 && config.maxDepth != 1) CHECK(tree.leaves.size() > 8);
  });
}

TEST_CASE("a leaf holds every primitive whose surface comes within rounding of it") {
  TestRandom random(1);
  forEveryTree([&](const FlatScene& flat, const KdConfig&, const KdTree& tree) {
    double const slack = std::ldexp(flat.reach, -22);  // a quarter of what the builder promises
    int missing = 0;
    std::uint32_t const step = flat.primitiveCount() / 500 + 1;
    std::vector<const KdLeaf*> leaves;
    for (std::uint32_t p = 0; p < flat.primitiveCount(); p += step)
      for (int i = 0; i < 10; ++i) {
        leaves.clear();
        leavesAt(tree, 0, surfacePoint(flat, p, random), slack, leaves);
        for (const KdLeaf* leaf : leaves) missing += !holds(tree, *leaf, p);
      }
    CHECK(missing == 0);
  });
}

TEST_CASE("a sphere is not in the leaves inside it, nor in those beyond its bounds") {
  for (bool room : {true, false}) {
    FlatScene const flat = room ? insideSphere() : mixedShapes();
    KdTree const tree = buildKdTree(flat, KdConfig{});
    int inside = 0, beyond = 0, wrong = 0;
    for (const KdLeaf& leaf : tree.leaves)
      for (std::size_t s = 0; s < flat.spheres.size(); ++s) {
        std::uint32_t const p = std::uint32_t(flat.quads.size() + s);
        Mat3d const toObject = glm::inverse(flat.spheres[s].toWorld);
        double farthest = 0;
        for (int i = 0; i < 8; ++i) {
          Vec3d const corner(leaf.bounds[i & 1 ? 3 : 0], leaf.bounds[i & 2 ? 4 : 1], leaf.bounds[i & 4 ? 5 : 2]);
          farthest = std::max(farthest, glm::length(toObject * (corner - flat.spheres[s].center)));
        }
        Bounds cell, bounds = flat.primitiveBounds(p);
        cell.grow(Vec3d(leaf.bounds[0], leaf.bounds[1], leaf.bounds[2]) - 1e-4);
        cell.grow(Vec3d(leaf.bounds[3], leaf.bounds[4], leaf.bounds[5]) + 1e-4);
        bool const isInside = farthest < 0.99, isBeyond = !cell.overlaps(bounds);
        inside += isInside;
        beyond += isBeyond;
        wrong += (isInside || isBeyond) && holds(tree, leaf, p);
      }
    CHECK((room ? inside : beyond) > 100);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a walk by ropes passes every cell along the ray once, in order") {
  TestRandom random(2);
  forEveryTree([&](const FlatScene&, const KdConfig&, const KdTree& tree) {
    KdTreeView const view = viewOf(tree);
    int missed = 0, repeated = 0, backward = 0;
    for (int i = 0; i < 50; ++i) {
      cpu::Ray const ray{cpu::Vec3(random.inBox(1.5)), cpu::Vec3(random.direction())};
      float last = 0;
      std::size_t visited = 0, crossed = 0;
      cpu::traverseRopes(
          view, ray, [](std::uint32_t) {},
          [&](float t) {
            backward += t < last;
            last = t;
            return ++visited > tree.leaves.size();
          });
      for (const KdLeaf& leaf : tree.leaves) {
        double enter = 0, exit = 1e300;
        for (int a = 0; a < 3; ++a) {
          double const o = double(ray.origin[a]), d = double(ray.direction[a]);
          double const t0 = (double(leaf.bounds[a]) - o) / d, t1 = (double(leaf.bounds[a + 3]) - o) / d;
          enter = std::max(enter, std::min(t0, t1));
          exit = std::min(exit, std::max(t0, t1));
        }
        crossed += enter + 1e-5 < exit;  // more than a touch
      }
      missed += visited < crossed;
      repeated += visited > tree.leaves.size();
    }
    CHECK(missed == 0);
    CHECK(repeated == 0);
    CHECK(backward == 0);
  });
}

TEST_CASE("the surface-area heuristic is worth it") {
  for (const GeometryScene& scene : geometryScenes()) {
    if (scene.flat.primitiveCount() < 100 || scene.name == "coincident triangles") continue;
    CAPTURE(scene.name);
    KdConfig midpoint;
    midpoint.split = KdSplit::midpoint;
    double const cost = buildKdTree(scene.flat, KdConfig{}).stats.sahCost;
    CHECK(cost < buildKdTree(scene.flat, midpoint).stats.sahCost);
    CHECK(cost < 0.8 * double(scene.flat.primitiveCount()));
  }
}
