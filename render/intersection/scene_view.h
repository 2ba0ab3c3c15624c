#pragma once
// What kernels see of a scene: spans of plain data.

#include <cstring>

#include "render/bsdf/bsdfs.h"
#include "render/core/span.h"
#include "render/flat/layer.h"
#include "render/intersection/instance.h"
#include "render/scene/side.h"

namespace ropelight::RL_TARGET {

/// A BSDF of any kind; `kind` is its index in Bsdfs.
struct Material {
  std::uint32_t kind = 0;
  float data[11] = {};
};

/// A diffuse emitter. side: bits of ropelight::Side. pick: probability that light sampling chooses it, ∝ power.
struct Light {
  std::uint32_t primitive = 0;
  std::uint32_t side = 1;
  Rgb radiance{0.0f};
  Real area = 0;  ///< of one side
  Real pick = 0;
};

struct SceneView {
  Span<const Quad> quads;
  Span<const Sphere> spheres;
  Span<const Triangle> triangles;
  Span<const Instance> instances;
  Span<const MeshView> meshes;         ///< that instances name
  Span<const std::uint32_t> material;  ///< by primitive
  Span<const std::int32_t> lightOf;    ///< by quad and sphere; −1: none
  Span<const Layer> layers;            ///< by primitive; empty where no surfaces coincide
  Span<const Material> materials;
  Span<const Light> lights;
  Span<const Real> lightCdf;         ///< inclusive sums of Light::pick
  Real power = 0;                    ///< of all lights: mean over the channels, watts
  std::uint32_t primitiveCount = 0;  ///< instances included; hits on their triangles have higher numbers
  KdTreeView tree;
  bool shortStack = false;  ///< how the tree is traversed
  BvhView<bvhWidth> bvh;
  Span<const Triangle> bvhTriangles;  ///< by item of the hierarchy; of other primitives the id alone
};

template <class T, class Kinds = Bsdfs>
RL_HD inline bool isKind(const Material& m) {
  return m.kind == std::uint32_t(Kinds::template indexOf<T>());
}

namespace detail {

template <FeatureBits F, class Kinds, class T, class Visit>
RL_HD inline void visitOne(const Material& m, Visit& visit) {
  if constexpr ((F & T::bit) != 0) {
    if (!isKind<T, Kinds>(m)) return;
    static_assert(sizeof(T) <= sizeof(m.data));
    T bsdf;
    std::memcpy(&bsdf, m.data, sizeof(T));
    visit(bsdf);
  }
}

template <FeatureBits F, class Visit, class... Ts>
RL_HD inline void visitAll(const Material& m, Visit& visit, List<Ts...>) {
  (visitOne<F, List<Ts...>, Ts>(m, visit), ...);
}

}  // namespace detail

/// Calls visit(bsdf) with the material's own type; kinds that F leaves out are not compiled in.
template <FeatureBits F, class Kinds = Bsdfs, class Visit>
RL_HD inline void visitBsdf(const Material& m, Visit&& visit) {
  detail::visitAll<F>(m, visit, Kinds{});
}

/// A point on a surface. n: unit outward geometric normal; error: bound on |computed − true| by axis.
struct Surface {
  Vec3 p{0}, error{0}, n{0, 0, 1};
  std::uint32_t primitive = noPrimitive;
  std::uint32_t material = 0;
  std::int32_t light = -1;
};

RL_HD inline void placeOn(const Quad& q, Real s, Real t, Surface& out) {
  Vec3 const e1 = q.b - q.a, e2 = q.d - q.a;
  out.p = q.a + e1 * s + e2 * t;
  out.error = gammaBound(8) * (absolute(q.a) + absolute(e1) + absolute(e2));
  out.n = q.n;
}

/// `local`: a point near the unit sphere; it is moved onto it.
RL_HD inline void placeOn(const Sphere& s, Vec3 local, Surface& out) {
  local = normalize(local);
  Vec3 const r = s.toWorld * local;
  Vec3 const bound = absolute(s.toWorld[0]) + absolute(s.toWorld[1]) + absolute(s.toWorld[2]);
  out.p = s.center + r;
  out.error = gammaBound(10) * (absolute(s.center) + bound);
  out.n = normalize(transpose(s.toObject) * local);
}

RL_HD inline void placeOn(const Triangle& t, Real u, Real v, Surface& out) {
  Vec3 const e1 = t.b - t.a, e2 = t.c - t.a;
  out.p = t.a + e1 * u + e2 * v;
  out.error = gammaBound(8) * (absolute(t.a) + absolute(e1) + absolute(e2));
  out.n = normalize(cross(e1, e2));
}

/// A triangle of an instance: on it in the mesh's space, then in the world. The bound is for the way there and back: a
/// ray that starts past it also starts past the triangle in the mesh's space.
RL_HD inline void placeOn(const Instance& instance, const Triangle& t, Real u, Real v, Surface& out) {
  placeOn(t, u, v, out);
  out.p = apply(instance.toWorld, out.p) + instance.center;
  Vec3 const terms = absolute(t.a) + absolute(t.b - t.a) + absolute(t.c - t.a);
  out.error = instance.rounding * terms + gammaBound(2) * absolute(instance.center);
  out.n = normalize(transpose(instance.toMesh) * out.n);
}

/// The instance whose triangles' numbers include that of a hit.
RL_HD inline std::uint32_t instanceOf(Span<const Instance> instances, std::uint32_t hit) {
  std::uint32_t low = 0, high = instances.size - 1;
  while (low < high) {
    std::uint32_t const middle = high - (high - low) / 2;
    if (instances[middle].firstHit <= hit)
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

RL_HD inline Surface surfaceOfInstance(const SceneView& scene, const Hit& hit) {
  Surface out;
  std::uint32_t const index = instanceOf(scene.instances, hit.primitive);
  const Instance& instance = scene.instances[index];
  out.primitive = hit.primitive;
  out.material = scene.material[scene.primitiveCount - scene.instances.size + index];
  placeOn(instance, scene.meshes[instance.mesh].triangles[hit.primitive - instance.firstHit], hit.u, hit.v, out);
  return out;
}

template <FeatureBits F>
RL_HD inline Surface surfaceAt(const SceneView& scene, const Ray& ray, const Hit& hit) {
  std::uint32_t id = hit.primitive;
  if constexpr ((F & feature::instances) != 0)
    if (id >= scene.primitiveCount) return surfaceOfInstance(scene, hit);
  Surface out;
  out.primitive = id;
  out.material = scene.material[id];
  if (id < scene.lightOf.size) out.light = scene.lightOf[id];
  if constexpr ((F & feature::quads) != 0) {
    if (id < scene.quads.size) {
      placeOn(scene.quads[id], hit.u, hit.v, out);
      return out;
    }
  }
  id -= scene.quads.size;
  if constexpr ((F & feature::spheres) != 0) {
    if (id < scene.spheres.size) {
      const Sphere& s = scene.spheres[id];
      placeOn(s, s.toObject * (ray.origin - s.center) + (s.toObject * ray.direction) * hit.t, out);
      return out;
    }
  }
  id -= scene.spheres.size;
  if constexpr ((F & feature::triangles) != 0) placeOn(scene.triangles[id], hit.u, hit.v, out);
  return out;
}

/// Radiance that a surface emits towards w (unit, away from it).
RL_HD inline Rgb emitted(const SceneView& scene, const Surface& s, Vec3 w) {
  if (s.light < 0) return Rgb(0.0f);
  const Light& light = scene.lights[std::uint32_t(s.light)];
  std::uint32_t const side = dot(w, s.n) > 0 ? std::uint32_t(Side::out) : std::uint32_t(Side::in);
  return (light.side & side) != 0 ? light.radiance : Rgb(0.0f);
}

}  // namespace ropelight::RL_TARGET
