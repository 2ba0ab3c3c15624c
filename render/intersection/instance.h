#pragma once
// Instanced meshes, their placements in the world, and how a ray hits one.

#include "render/geometry/primitives.h"
#include "render/intersection/traverse.h"

namespace ropelight::RL_TARGET {

/// Children of a node of the hierarchy that the renderer uses: four fill a CPU's vectors, two a GPU's registers.
inline constexpr int bvhWidth = RL_CUDA_TARGET ? 2 : 4;

/// Triangles by number. Where there is a BVH they lie in the order of its items, once, and `places` says where each is.
struct TriangleList {
  Span<const Triangle> triangles;
  Span<const std::uint32_t> places;  ///< empty: in the order of their numbers
  std::uint32_t size = 0;

  RL_HD const Triangle& operator[](std::uint32_t k) const { return triangles[places.empty() ? k : places[k]]; }
};

/// A mesh within [−1, 1] and the structure over it, of the same kind as that over the scene.
struct MeshView {
  TriangleList triangles;
  KdTreeView tree;
  bool shortStack = false;  ///< how the tree is traversed
  BvhView<bvhWidth> bvh;
  Span<const Triangle> bvhTriangles;  ///< by item of the hierarchy
};

/// An affine image of a mesh: x_mesh = toMesh·(x_world − center). What traversal reads comes first.
struct alignas(16) Instance {
  Mat3 toMesh;
  Vec3 center;
  std::uint32_t mesh = 0;
  std::uint32_t firstHit = 0;  ///< number of a hit on the mesh's first triangle
  Mat3 toWorld;
  Mat3 rounding;  ///< bound on the error of a point in the world, by that of its terms in the mesh's space
};

/// m·v, contracted alike wherever it is inlined.
RL_HD inline Vec3 apply(const Mat3& m, Vec3 v) {
  Vec3 r;
  for (int a = 0; a < 3; ++a) r[a] = mulAdd(m[0][a], v.x, mulAdd(m[1][a], v.y, mulRounded(m[2][a], v.z)));
  return r;
}

/// A ray in a mesh's space, begun where it comes near: the parameter in the world is `skipped` more.
struct MeshRay {
  Ray ray;
  Real skipped = 0;

  /// Parameter of the ray up to which hits may come before the parameter t in the world; with room for all that rounds
  /// to t when `skipped` is added.
  RL_HD Real limit(Real t) const { return skipped > 0 ? (t - skipped) + 4 * machineEpsilon * t : t; }
};

/// False where the ray misses the cube [−2, 2]³ around the mesh. It begins at the cube where it begins outside: origins
/// then lie within the reach of the mesh's structure, and hits from afar are as precise as those from nearby. Origins
/// inside the cube stay, so that rays that leave the mesh start where they should.
RL_HD inline bool enterMesh(const Instance& instance, const Ray& ray, MeshRay& out) {
  Vec3 const o = apply(instance.toMesh, ray.origin - instance.center), d = apply(instance.toMesh, ray.direction);
  Real enter = 0, leave = infinity;
  for (int a = 0; a < 3; ++a) {
    Real const inverse = 1 / d[a];
    Real const low = (-2 - o[a]) * inverse, high = (2 - o[a]) * inverse;  // NaN only along a face of the cube
    Real const first = minOf(low, high), last = maxOf(low, high);
    if (first > enter) enter = first;
    if (last < leave) leave = last;
  }
  if (!(enter <= leave) || !isFinite(enter)) return false;
  for (int a = 0; a < 3; ++a) out.ray.origin[a] = mulAdd(d[a], enter, o[a]);
  out.ray.direction = d;
  out.skipped = enter;
  return true;
}

/// Improves `hit`, whose numbers are those of the mesh's triangles, until stop().
template <FeatureBits F, class Stop>
RL_HD inline void intersect(const MeshView& mesh, const Ray& ray, Hit& hit, Stop&& stop) {
  RayShear const shear(ray);
  if constexpr ((F & feature::bvh) != 0) {
    auto const test = [&](std::uint32_t item) {
      Triangle const triangle = mesh.bvhTriangles[item];
      intersect(triangle, shear, triangle.id, hit);
    };
    if (!mesh.bvh.nodes.empty()) return traverseBvh(mesh.bvh, ray, test, [&] { return stop() ? Real(-1) : hit.t; });
  }
  auto const test = [&](std::uint32_t k) { intersect(mesh.triangles[k], shear, k, hit); };
  if constexpr ((F & feature::tree) != 0)
    if (!mesh.tree.nodes.empty()) return traverseTree<F>(mesh, ray, test, [&](Real t) { return stop() || hit.t <= t; });
  for (std::uint32_t k = 0; k < mesh.triangles.size && !stop(); ++k) test(k);
}

/// Replaces `hit` where the instance is met before it; `anyHit`: any place will do. F: the structures to look for.
template <FeatureBits F, bool anyHit>
RL_HD inline void intersect(Span<const MeshView> meshes, const Instance& instance, const Ray& ray, Hit& hit) {
  MeshRay local;
  if (!enterMesh(instance, ray, local) || local.skipped > hit.t) return;
  Hit found;
  found.t = local.limit(hit.t);
  auto const counts = [&] {
    return found.found() && hit.improvedBy(local.skipped + found.t, instance.firstHit + found.primitive);
  };
  intersect<F>(meshes[instance.mesh], local.ray, found, [&] { return anyHit && counts(); });
  if (counts()) hit = Hit{local.skipped + found.t, instance.firstHit + found.primitive, found.u, found.v};
}

}  // namespace ropelight::RL_TARGET
