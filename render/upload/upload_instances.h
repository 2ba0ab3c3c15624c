#pragma once
// Instanced meshes and their placements on a backend: the lists of all meshes in one buffer a kind.

#include "accel/bvh/build.h"
#include "render/intersection/scene_view.h"
#include "render/upload/structures.h"

namespace ropelight::RL_TARGET {

inline Triangle toTarget(const FlatTriangle& t) { return Triangle{Vec3(t.a), 0, Vec3(t.b), 0, Vec3(t.c), 0}; }

/// By item of a hierarchy: the triangle with its primitive id, or of another primitive the id alone.
inline std::vector<Triangle> itemTriangles(const FlatScene& flat, const std::vector<std::uint32_t>& items) {
  std::size_t const first = flat.quads.size() + flat.spheres.size(), end = first + flat.triangles.size();
  std::vector<Triangle> triangles(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i] >= first && items[i] < end) triangles[i] = toTarget(flat.triangles[items[i] - first]);
    triangles[i].id = items[i];
  }
  return triangles;
}

/// The bound of `rounding`: each way the terms are rounded as often as placeOn and enterMesh say, those of the way back
/// spread by both matrices.
inline Instance toTarget(const FlatInstance& i) {
  auto const absolute = [](const Mat3d& m) { return Mat3d(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])); };
  Mat3d const linear(i.toWorld), inverse = glm::inverse(linear);
  Mat3d const there = absolute(linear), back = there * absolute(inverse) * there;
  Instance out;
  out.toMesh = Mat3(inverse);
  out.center = Vec3(Vec3d(i.toWorld[3]));
  out.mesh = i.mesh;
  out.firstHit = i.firstHit;
  out.toWorld = Mat3(linear);
  out.rounding = Mat3(double(gammaBound(16)) * there + double(gammaBound(8)) * back);
  return out;
}

/// Where each of `count` triangles lies among the items; `first`: the primitive id of triangle 0.
inline std::vector<std::uint32_t> placesOf(const std::vector<std::uint32_t>& items, std::size_t first,
                                           std::size_t count) {
  std::vector<std::uint32_t> places(count);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i] >= first && items[i] - first < count) places[items[i] - first] = std::uint32_t(i);
  return places;
}

template <class Backend>
class DeviceInstances {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  /// Fills the view's instances and meshes; nothing where the scene has none.
  void upload(Backend& backend, const SceneStructures& p, SceneView& view) {
    const FlatScene& flat = *p.flat;
    if (flat.instances.empty()) return;
    std::vector<Instance> instances;
    for (const FlatInstance& i : flat.instances) instances.push_back(toTarget(i));
    view.instances = copy(backend, instances_, instances);
    std::vector<MeshView> meshes(flat.meshes.size());
    if (!(p.features & feature::bvh)) uploadTriangles(backend, flat, meshes);
    if (p.features & feature::tree) uploadTrees(backend, p, meshes);
    if (p.features & feature::bvh) uploadBvhs(backend, p, meshes);
    view.meshes = copy(backend, meshes_, meshes);
  }

 private:
  template <class T>
  static Span<const T> copy(Backend& backend, Buffer<T>& to, const std::vector<T>& from) {
    to.allocate(backend, "instances", from.size());
    backend.upload(to, from.data(), from.size());
    return to.view();
  }

  /// The lists of all meshes as one, and the part of each.
  template <class T>
  class Joined {
   public:
    void add(const std::vector<T>& part) {
      starts_.push_back(all_.size());
      all_.insert(all_.end(), part.begin(), part.end());
    }
    /// set(mesh, its part), for every mesh.
    template <class Set>
    void copyTo(Backend& backend, Buffer<T>& buffer, Set&& set) {
      Span<const T> const all = copy(backend, buffer, all_);
      starts_.push_back(all_.size());
      for (std::size_t m = 0; m + 1 < starts_.size(); ++m)
        set(m, Span<const T>{all.data + starts_[m], std::uint32_t(starts_[m + 1] - starts_[m])});
    }

   private:
    std::vector<T> all_;
    std::vector<std::size_t> starts_;
  };

  /// By number, for meshes without a BVH.
  void uploadTriangles(Backend& backend, const FlatScene& flat, std::vector<MeshView>& meshes) {
    Joined<Triangle> triangles;
    for (const auto& mesh : flat.meshes) {
      std::vector<Triangle> part;
      for (const FlatTriangle& t : mesh->triangles) part.push_back(toTarget(t));
      triangles.add(part);
    }
    triangles.copyTo(backend, triangles_, [&](std::size_t m, auto part) {
      meshes[m].triangles = TriangleList{part, {}, part.size};
    });
  }

  void uploadTrees(Backend& backend, const SceneStructures& p, std::vector<MeshView>& meshes) {
    Joined<KdNode> nodes;
    Joined<KdLeaf> leaves;
    Joined<std::uint32_t> references;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const KdTree& tree = (*p.meshTrees)[m];
      nodes.add(tree.nodes);
      leaves.add(tree.leaves);
      references.add(tree.references);
      std::memcpy(meshes[m].tree.bounds, tree.bounds, sizeof(tree.bounds));
      meshes[m].shortStack = (p.features & feature::shortStack) != 0;
    }
    nodes.copyTo(backend, nodes_, [&](std::size_t m, auto part) { meshes[m].tree.nodes = part; });
    leaves.copyTo(backend, leaves_, [&](std::size_t m, auto part) { meshes[m].tree.leaves = part; });
    references.copyTo(backend, references_, [&](std::size_t m, auto part) { meshes[m].tree.references = part; });
  }

  void uploadBvhs(Backend& backend, const SceneStructures& p, std::vector<MeshView>& meshes) {
    Joined<BvhNode<bvhWidth>> nodes;
    Joined<Triangle> triangles;
    Joined<std::uint32_t> places;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const Bvh<2>& bvh = (*p.meshBvhs)[m];
      const FlatScene& mesh = *p.flat->meshes[m];
      if constexpr (bvhWidth == 2)
        nodes.add(bvh.nodes);
      else
        nodes.add(widen(bvh).nodes);
      triangles.add(itemTriangles(mesh, bvh.items));
      places.add(placesOf(bvh.items, 0, mesh.triangles.size()));
    }
    nodes.copyTo(backend, bvhNodes_, [&](std::size_t m, auto part) { meshes[m].bvh.nodes = part; });
    triangles.copyTo(backend, triangles_, [&](std::size_t m, auto part) { meshes[m].bvhTriangles = part; });
    places.copyTo(backend, places_, [&](std::size_t m, auto part) {
      meshes[m].triangles = TriangleList{meshes[m].bvhTriangles, part, part.size};
    });
  }

  Buffer<Instance> instances_;
  Buffer<MeshView> meshes_;
  Buffer<Triangle> triangles_;
  Buffer<KdNode> nodes_;
  Buffer<KdLeaf> leaves_;
  Buffer<std::uint32_t> references_;
  Buffer<BvhNode<bvhWidth>> bvhNodes_;
  Buffer<std::uint32_t> places_;
};

}  // namespace ropelight::RL_TARGET
