// The search: shapes whose boxes overlap give candidates, a BVH over those gives pairs, and geometry decides.

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "accel/bvh/build.h"
#include "render/coincidence/coincident.h"

namespace ropelight {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
constexpr std::uint64_t mostPlacedTriangles = 1u << 26;
constexpr std::size_t mostForeignBoxes = 32;  // more are not worth a test each
constexpr std::size_t fewFacets = 48;         // up to here every pair is tested

Vec3d apply(const Mat4d& m, Vec3d p) { return Vec3d(m * glm::dvec4(p, 1.0)); }

bool transmits(const Scene& scene, const ShapeDesc& shape) {
  return std::visit([](const auto& params) { return params.transmits; },
                    scene.materials[std::size_t(shape.material)].desc);
}

/// Whether it matters which of two surfaces of these shapes a ray hits first.
bool orderMatters(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  const ShapeDesc &s = scene.shapes[a], &t = scene.shapes[b];
  bool const clear = transmits(scene, s) || transmits(scene, t);
  return clear || (a != b && (s.material != t.material || s.emission || t.emission));
}

/// A quad, an ellipsoid, or a whole mesh: primitives [first, end), or one instance.
struct Thing {
  std::uint32_t shape, first, end;
  const FlatInstance* instance = nullptr;
  Bounds box;
};

class Search {
 public:
  Search(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf)
      : scene_(scene), flat_(flat), shapeOf_(shapeOf) {
    // Rounding of a computed point at the scene's farthest coordinate, with the room that tolerances have.
    Vec3d const far = glm::max(glm::abs(flat.bounds.min), glm::abs(flat.bounds.max));
    pad_ = 0x1p-24 * 128 * std::max({far.x, far.y, far.z});
  }

  CoincidentPairs run() {
    listThings();
    for (const Thing& thing : things_) addCandidates(thing);
    if (found_.facets.size() <= fewFacets)
      testAll();
    else
      testNear();
    takeHidden(scene_, flat_, found_);
    notePlaced();
    return std::move(found_);
  }

 private:
  std::uint32_t firstTriangle() const { return std::uint32_t(flat_.quads.size() + flat_.spheres.size()); }
  std::uint32_t firstInstance() const { return firstTriangle() + std::uint32_t(flat_.triangles.size()); }

  void listThings() {
    for (std::uint32_t i = 0; i < flat_.primitiveCount(); ++i) {
      bool const triangle = i >= firstTriangle() && i < firstInstance();
      if (!triangle || things_.empty() || things_.back().shape != shapeOf_[i] || things_.back().instance)
        things_.push_back({shapeOf_[i], i, i, nullptr, {}});
      Thing& thing = things_.back();
      thing.end = i + 1;
      if (i >= firstInstance()) {
        thing.instance = &flat_.instances[i - firstInstance()];
        thing.box.grow(thing.instance->bounds);
      } else {
        thing.box.grow(flat_.primitiveBounds(i));
      }
    }
  }

  bool meet(const Bounds& a, const Bounds& b) const { return a.overlaps({b.min - Vec3d(pad_), b.max + Vec3d(pad_)}); }

  /// Boxes of the things of other shapes that some triangle of a mesh may touch.
  std::vector<Bounds> foreignBoxes(const Thing& thing) const {
    std::vector<Bounds> boxes;
    for (const Thing& other : things_)
      if (other.shape != thing.shape && meet(thing.box, other.box) && orderMatters(scene_, thing.shape, other.shape))
        boxes.push_back(other.box);
    return boxes;
  }

  void addFacet(Facet facet, std::uint32_t primitive) {
    facet.primitive = primitive;
    facet.shape = shapeOf_[primitive];
    found_.facets.push_back(facet);
  }

  void addCandidates(const Thing& thing) {
    if (thing.first < flat_.quads.size()) return addFacet(makeFacet(flat_.quads[thing.first]), thing.first);
    if (thing.first < firstTriangle())
      return addFacet(makeFacet(flat_.spheres[thing.first - flat_.quads.size()]), thing.first);
    bool const all = transmits(scene_, scene_.shapes[thing.shape]);
    std::vector<Bounds> const boxes = all ? std::vector<Bounds>() : foreignBoxes(thing);
    if (!all && boxes.empty()) return;
    auto const add = [&](const FlatTriangle& t, std::uint32_t primitive) {
      Bounds box;
      for (Vec3d p : {t.a, t.b, t.c}) box.grow(p);
      bool const candidate = all || boxes.size() > mostForeignBoxes ||
                             std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& b) { return meet(box, b); });
      if (candidate) addFacet(makeFacet(t), primitive);
    };
    if (thing.instance) return addPlaced(*thing.instance, thing.first, add);
    for (std::uint32_t i = thing.first; i < thing.end; ++i) add(flat_.triangles[i - firstTriangle()], i);
  }

  template <class Add>
  void addPlaced(const FlatInstance& instance, std::uint32_t primitive, Add&& add) {
    const std::vector<FlatTriangle>& triangles = flat_.meshes[instance.mesh]->triangles;
    placedTriangles_ += triangles.size();
    if (placedTriangles_ > mostPlacedTriangles) return;
    const Mat4d& m = instance.toWorld;
    for (const FlatTriangle& t : triangles) add({apply(m, t.a), apply(m, t.b), apply(m, t.c)}, primitive);
  }

  bool isPair(const Facet& a, const Facet& b) const {
    if (!orderMatters(scene_, a.shape, b.shape)) return false;
    if (a.shape == b.shape && (a.curved() || glm::dot(a.normal, b.normal) > 0)) return false;
    return meet(a.box, b.box) && coincide(a, b);
  }

  void testAll() {
    std::uint32_t const n = std::uint32_t(found_.facets.size());
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = i + 1; j < n; ++j)
        if (isPair(found_.facets[i], found_.facets[j])) found_.pairs.push_back({i, j});
  }

  void testNear() {
    std::vector<std::uint32_t> facetOf;
    Bvh<2> const bvh = hierarchy(facetOf);
    oneapi::tbb::enumerable_thread_specific<std::vector<Pair>> local;
    std::uint32_t const n = std::uint32_t(found_.facets.size());
    oneapi::tbb::parallel_for(std::uint32_t(0), n, [&](std::uint32_t i) {
      std::vector<Pair>& pairs = local.local();
      forEachNear(bvh, found_.facets[i].box, [&](std::uint32_t item) {
        std::uint32_t const j = facetOf[item];
        if (j > i && isPair(found_.facets[i], found_.facets[j])) pairs.push_back({i, j});
      });
    });
    for (const auto& pairs : local) found_.pairs.insert(found_.pairs.end(), pairs.begin(), pairs.end());
    std::sort(found_.pairs.begin(), found_.pairs.end());
    found_.pairs.erase(std::unique(found_.pairs.begin(), found_.pairs.end()), found_.pairs.end());
  }

  /// Over the facets as a scene of their own; facetOf: by its primitive numbers.
  Bvh<2> hierarchy(std::vector<std::uint32_t>& facetOf) const {
    FlatScene scene;
    std::vector<std::uint32_t> quads, spheres, triangles;
    for (std::uint32_t i = 0; i < found_.facets.size(); ++i) {
      const Facet& f = found_.facets[i];
      if (f.corners == 4) {
        scene.quads.push_back({{f.corner[0], f.corner[1], f.corner[2], f.corner[3]}});
        quads.push_back(i);
      } else if (f.corners == 3) {
        scene.triangles.push_back({f.corner[0], f.corner[1], f.corner[2]});
        triangles.push_back(i);
      } else {
        scene.spheres.push_back(f.sphere);
        spheres.push_back(i);
      }
    }
    for (const auto* part : {&quads, &spheres, &triangles}) facetOf.insert(facetOf.end(), part->begin(), part->end());
    scene.bounds = flat_.bounds;
    scene.reach = reachOf(flat_.bounds, Vec3d(0.0));
    BvhConfig quick;
    quick.sweep = false;
    quick.reinsertion = 0;
    return buildBvh(scene, quick);
  }

  /// Calls visit(primitive) for what the BVH holds near a box.
  template <class Visit>
  void forEachNear(const Bvh<2>& bvh, const Bounds& box, Visit&& visit) const {
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const BvhNode<2>& node = bvh.nodes[open.back()];
      open.pop_back();
      for (int c = 0; c < 2; ++c) {
        Bounds const child{Vec3d(node.min[0][c], node.min[1][c], node.min[2][c]),
                           Vec3d(node.max[0][c], node.max[1][c], node.max[2][c])};
        if (!meet(box, child)) continue;
        if (!node.child[c].isLeaf()) {
          open.push_back(node.child[c].index());
          continue;
        }
        for (std::uint32_t k = 0; k < node.child[c].count(); ++k) visit(bvh.items[node.child[c].index() + k]);
      }
    }
  }

  void notePlaced() {
    for (const Pair& pair : found_.pairs)
      for (std::uint32_t f : {pair.first, pair.second})
        if (found_.facets[f].primitive >= firstInstance()) found_.placed.push_back(found_.facets[f].shape);
    std::sort(found_.placed.begin(), found_.placed.end());
    found_.placed.erase(std::unique(found_.placed.begin(), found_.placed.end()), found_.placed.end());
  }

  const Scene& scene_;
  const FlatScene& flat_;
  const std::vector<std::uint32_t>& shapeOf_;
  double pad_ = 0;
  std::vector<Thing> things_;
  std::uint64_t placedTriangles_ = 0;
  CoincidentPairs found_;
};

}  // namespace

CoincidentPairs findCoincident(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf) {
  return Search(scene, flat, shapeOf).run();
}

}  // namespace ropelight
