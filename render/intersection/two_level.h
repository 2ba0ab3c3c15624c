#pragma once
// One loop through the BVH over the scene and, wherever it comes to an instance, through that of the instance's mesh:
// on a GPU, lanes in the scene and lanes in a mesh advance together, and only one traversal's state is alive at a time.

#include "render/intersection/intersect_primitive.h"

namespace ropelight::RL_TARGET {

/// Stack of both levels: a mesh's entries lie above the scene's.
struct TwoLevelStack {
  BvhStack::Entry entries[2 * bvhDepthLimit + 4];
};

/// One ray's way through a scene that has a binary BVH, and so has each of its meshes. F: of the scene. anyHit: any hit
/// will do. Finds the same hits as a BVH with intersectPrimitive at its leaves.
template <FeatureBits F, bool anyHit>
class TwoLevelTraversal {
 public:
  /// `ignored` is not tested.
  RL_HD TwoLevelTraversal(const SceneView& scene, const Ray& ray, std::uint32_t ignored)
      : scene_(scene), world_(ray), ignored_(ignored), slabs_(ray), shear_(ray) {
    hit_.t = ray.tMax;
    nodes_ = scene.bvh.nodes.data;
    items_ = scene.bvhTriangles.data;
  }

  RL_HD Hit run() {
    TwoLevelStack stack;
    for (bool more = true; more;) {
      while (more && !next_.isLeaf()) more = descend(stack);
      if (more) more = testLeaf(stack) || pop(stack);
    }
    return hit_;
  }

 private:
  RL_HD bool inMesh() const { return base_ >= 0; }

  /// Whether the hit in the mesh is nearer than the one outside.
  RL_HD bool improves() const {
    return hit_.found() && outside_.improvedBy(skipped_ + hit_.t, firstHit_ + hit_.primitive);
  }

  RL_HD Real limit() const {
    if constexpr (anyHit)
      if (inMesh() ? improves() : hit_.found()) return -1;
    return hit_.t;
  }

  /// From an inner node to the nearer child that the ray hits, or to what is left; false where nothing is.
  RL_HD bool descend(TwoLevelStack& stack) {
    BvhNode<2> const node = nodes_[next_.index()];
    Real const most = limit();
    Slab const a = clip(node, 0, slabs_, most), b = clip(node, 1, slabs_, most);
    bool const hitsA = a.near <= a.far, hitsB = b.near <= b.far;
    if (!hitsA && !hitsB) return pop(stack);
    bool const second = hitsB && (!hitsA || b.near < a.near);
    next_ = second ? node.child[1] : node.child[0];
    if (hitsA && hitsB) stack.entries[size_++] = {second ? node.child[0] : node.child[1], second ? a.near : b.near};
    return true;
  }

  /// To the nearest node left that is entered before the limit, out of the mesh where it is done; false where there is
  /// none.
  RL_HD bool pop(const TwoLevelStack& stack) {
    for (;;) {
      Real const most = limit();
      int const floor = inMesh() ? base_ : 0;
      while (size_ > floor) {
        BvhStack::Entry const e = stack.entries[--size_];
        next_ = e.child;
        if (e.near <= most) return true;
      }
      if (!inMesh()) return false;
      leaveMesh();
    }
  }

  /// Tests the items of a leaf; true where one of them led into a mesh.
  RL_HD bool testLeaf(TwoLevelStack& stack) {
    for (std::uint32_t k = next_.index(), end = k + next_.count(); k < end; ++k) {
      Triangle const triangle = items_[k];  // as a whole: a GPU loads it in three words
      std::uint32_t const id = triangle.id;
      if (inMesh()) {
        intersect(triangle, shear_, id, hit_);
      } else if (id != ignored_) {
        std::uint32_t const shapes = scene_.quads.size + scene_.spheres.size;
        if (id - shapes < scene_.triangles.size) {  // wraps for quads and spheres
          intersect(triangle, shear_, id, hit_);
        } else if (id < shapes) {
          constexpr FeatureBits others = F & ~(feature::triangles | feature::instances);
          intersectPrimitive<others>(scene_, world_, shear_, id, hit_);
        } else if (enterMesh(scene_.instances[id - shapes - scene_.triangles.size])) {
          if (k + 1 < end) stack.entries[size_++] = {BvhChild::leaf(k + 1, end - k - 1), 0};
          base_ = size_;
          return true;
        }
      }
    }
    return false;
  }

  RL_HD bool enterMesh(const Instance& instance) {
    MeshRay local;
    if (!ropelight::RL_TARGET::enterMesh(instance, world_, local) || local.skipped > hit_.t) return false;
    outside_ = hit_;
    skipped_ = local.skipped;
    firstHit_ = instance.firstHit;
    hit_ = Hit{};
    hit_.t = local.limit(outside_.t);
    const MeshView& mesh = scene_.meshes[instance.mesh];
    follow(local.ray, mesh.bvh, mesh.bvhTriangles);
    next_ = BvhChild::inner(0);
    return true;
  }

  RL_HD void leaveMesh() {
    if (improves()) outside_ = Hit{skipped_ + hit_.t, firstHit_ + hit_.primitive, hit_.u, hit_.v};
    hit_ = outside_;
    base_ = -1;
    follow(world_, scene_.bvh, scene_.bvhTriangles);
  }

  RL_HD void follow(const Ray& ray, const BvhView<2>& bvh, Span<const Triangle> items) {
    slabs_ = SlabRay(ray);
    shear_ = RayShear(ray);
    nodes_ = bvh.nodes.data;
    items_ = items.data;
  }

  const SceneView& scene_;
  Ray world_;
  std::uint32_t ignored_;
  SlabRay slabs_;
  RayShear shear_;
  const BvhNode<2>* nodes_;
  const Triangle* items_;
  BvhChild next_ = BvhChild::inner(0);
  int size_ = 0;
  int base_ = -1;  ///< of the mesh's entries in the stack; negative outside meshes
  Hit hit_;        ///< in the mesh: of its triangles, along the ray there
  Hit outside_;    ///< in the mesh: the one in the world
  Real skipped_ = 0;
  std::uint32_t firstHit_ = 0;
};

}  // namespace ropelight::RL_TARGET
