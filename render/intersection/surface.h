#pragma once
// Points on surfaces: where a hit is, what lies there, and how exactly that is known.

#include "render/intersection/scene_view.h"

namespace ropelight::RL_TARGET {

/// A point on a surface. n: unit outward geometric normal; error: bound on |computed − true| by axis. uv, tangent and
/// shadingNormal are filled with feature::shading alone: nothing else pays for them.
struct Surface {
  Vec3 p{0}, error{0}, n{0, 0, 1};
  Vec2 uv{0};                   ///< of a quad along its edges, of a triangle its barycentrics, of a sphere longitude
                                ///< and latitude over their ranges; in [0, 1]
  Vec3 tangent{1, 0, 0};        ///< unit, along growing u
  Vec3 shadingNormal{0, 0, 1};  ///< unit; n where nothing else is given
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

/// What textures and shading normals need, for feature::shading.
RL_HD inline void shade(const Quad& q, Real u, Real v, Surface& out) {
  out.uv = Vec2(u, v);
  out.tangent = normalize(q.b - q.a);
  out.shadingNormal = out.n;
}

RL_HD inline void shade(const Triangle& t, Real u, Real v, Surface& out) {
  out.uv = Vec2(u, v);
  out.tangent = normalize(t.b - t.a);
  out.shadingNormal = out.n;
}

/// Longitude from the object's +x towards +y, latitude from its −z to its +z. At the poles any tangent will do.
RL_HD inline void shade(const Sphere& s, Vec3 local, Surface& out) {
  local = normalize(local);
  Real const turn = atan2(local.y, local.x) * (invPi / 2);
  out.uv = Vec2(turn < 0 ? turn + 1 : turn, acos(minOf(maxOf(-local.z, Real(-1)), Real(1))) * invPi);
  Vec3 const along(-local.y, local.x, 0);
  Vec3 const world = s.toWorld * (lengthSquared(along) > 0 ? along : Vec3(0, 1, 0));
  out.tangent = normalize(world);
  out.shadingNormal = out.n;
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
      if constexpr ((F & feature::shading) != 0) shade(scene.quads[id], hit.u, hit.v, out);
      return out;
    }
  }
  id -= scene.quads.size;
  if constexpr ((F & feature::spheres) != 0) {
    if (id < scene.spheres.size) {
      const Sphere& s = scene.spheres[id];
      Vec3 const local = s.toObject * (ray.origin - s.center) + (s.toObject * ray.direction) * hit.t;
      placeOn(s, local, out);
      if constexpr ((F & feature::shading) != 0) shade(s, local, out);
      return out;
    }
  }
  id -= scene.spheres.size;
  if constexpr ((F & feature::triangles) != 0) {
    placeOn(scene.triangles[id], hit.u, hit.v, out);
    if constexpr ((F & feature::shading) != 0) shade(scene.triangles[id], hit.u, hit.v, out);
  }
  return out;
}

/// Calls visit(bsdf) for what the surface's material is there. Parameters that vary over a surface are looked up here.
template <FeatureBits F, class Visit>
RL_HD inline void bsdfAt(const SceneView& scene, const Surface& s, Visit&& visit) {
  visitBsdf<F>(scene.materials[s.material], visit);
}

/// Radiance that a surface emits towards w (unit, away from it).
RL_HD inline Rgb emitted(const SceneView& scene, const Surface& s, Vec3 w) {
  if (s.light < 0) return Rgb(0.0f);
  const Light& light = scene.lights[std::uint32_t(s.light)];
  std::uint32_t const side = dot(w, s.n) > 0 ? std::uint32_t(Side::out) : std::uint32_t(Side::in);
  return (light.side & side) != 0 ? light.radiance : Rgb(0.0f);
}

}  // namespace ropelight::RL_TARGET
