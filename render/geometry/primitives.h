#pragma once
// What rays hit: parallelograms, ellipsoids and triangles, with their intersection tests.

#include "render/core/ray.h"

namespace ropelight::RL_TARGET {

/// A parallelogram a, b, c, d in order around it, with unit normal n ∥ (b − a) × (d − a). Boxes share corners bit for
/// bit.
struct Quad {
  Vec3 a, b, c, d;
  Vec3 n;
};

/// The image of the unit sphere under x ↦ toWorld·x + center.
struct Sphere {
  Mat3 toObject, toWorld;
  Vec3 center;
};

/// Padded so that a GPU reads each vertex at once. id: of the primitive, for triangles in the order of some leaves.
struct alignas(16) Triangle {
  Vec3 a;
  std::uint32_t id = 0;
  Vec3 b;
  std::uint32_t unusedB = 0;
  Vec3 c;
  std::uint32_t unusedC = 0;
};

/// The shear that takes a ray to the +z axis (Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection"). A
/// vertex shared by two primitives is sheared to the same bits in both: that makes the edge test watertight. On the
/// host the axes are permuted by index; in registers an index costs selects, so that there the shear is a matrix.
class RayShear {
 public:
  RL_HD explicit RayShear(const Ray& ray) : origin_(ray.origin) {
    Vec3 const m = absolute(ray.direction), d = ray.direction;
    kz_ = m.x > m.y ? (m.x > m.z ? 0 : 2) : (m.y > m.z ? 1 : 2);
    kx_ = kz_ == 2 ? 0 : kz_ + 1;
    ky_ = kx_ == 2 ? 0 : kx_ + 1;
    sz_ = 1 / pick(d, kz_);
    sx_ = pick(d, kx_) * sz_;
    sy_ = pick(d, ky_) * sz_;
#if RL_DEVICE_CODE
    rowX_ = column(kx_, 1) - column(kz_, sx_);
    rowY_ = column(ky_, 1) - column(kz_, sy_);
    rowZ_ = column(kz_, sz_);
#endif
  }

  RL_HD static Real pick(Vec3 v, int k) { return k == 0 ? v.x : (k == 1 ? v.y : v.z); }

  /// Length along the main axis in one unit of the ray parameter.
  RL_HD Real speed() const {
#if RL_DEVICE_CODE
    return 1 / maxAbs(rowZ_);
#else
    return 1 / abs(sz_);
#endif
  }

  /// x, y: across the ray; z: the ray parameter.
  RL_HD Vec3 operator()(const Vec3& v) const {
#if RL_DEVICE_CODE
    Vec3 const q = v - origin_;
    return Vec3(along(rowX_, q), along(rowY_, q), along(rowZ_, q));
#else
    const Real *p = &v.x, *o = &origin_.x;
    Real const z = p[kz_] - o[kz_];
    return Vec3(mulAdd(-sx_, z, p[kx_] - o[kx_]), mulAdd(-sy_, z, p[ky_] - o[ky_]), sz_ * z);
#endif
  }

 private:
  RL_HD static Vec3 column(int k, Real value) {
    return Vec3(k == 0 ? value : 0, k == 1 ? value : 0, k == 2 ? value : 0);
  }
  RL_HD static Real along(Vec3 row, Vec3 q) { return mulAdd(row.x, q.x, mulAdd(row.y, q.y, mulRounded(row.z, q.z))); }

  Vec3 origin_;
  int kx_, ky_, kz_;
  Real sx_, sy_, sz_;
  Vec3 rowX_, rowY_, rowZ_;  ///< of the matrix, on the device
};

/// Twice the signed area of (0, p, q): edge(q, p) is exactly −edge(p, q), and the sign is never wrong (it may be 0).
RL_HD inline Real edge(Vec3 p, Vec3 q) { return mulRounded(p.x, q.y) - mulRounded(p.y, q.x); }

/// The same, 0 only where it is: products of two floats are exact in double.
RL_HD inline Real edgeExact(Vec3 p, Vec3 q) { return Real(double(p.x) * double(q.y) - double(p.y) * double(q.x)); }

RL_HD inline bool mixedSigns(Real lowest, Real highest) { return lowest < 0 && highest > 0; }

/// Completes a hit of the sheared triangle p, q, r with edge values u, v, w; rejects t within its own error of zero
/// (pbrt-3, §3.9.6; here z counts ray parameters, and lengths only when it is multiplied by the ray's speed).
RL_HD inline bool hitTriangle(const RayShear& shear, Vec3 p, Vec3 q, Vec3 r, Real u, Real v, Real w, const Hit& hit,
                              std::uint32_t id, Real& t, Real& inverse) {
  Real const det = u + v + w;
  if (det == 0) return false;
  inverse = 1 / det;
  t = (u * p.z + v * q.z + w * r.z) * inverse;
  if (!(t > 0) || !hit.improvedBy(t, id)) return false;
  Real const maxX = maxAbs(Vec3(p.x, q.x, r.x)), maxY = maxAbs(Vec3(p.y, q.y, r.y));
  Real const maxZ = maxAbs(Vec3(p.z, q.z, r.z)), maxE = maxAbs(Vec3(u, v, w));
  // t lies between the corners': where all are clearly ahead it needs no bound, which for needles seen edge-on is huge.
  if (minOf(p.z, minOf(q.z, r.z)) > gammaBound(16) * maxZ) return true;
  Real const depth = maxZ * shear.speed();
  Real const deltaX = gammaBound(5) * (maxX + depth), deltaY = gammaBound(5) * (maxY + depth);
  Real const deltaZ = gammaBound(3) * maxZ;
  Real const deltaE = 2 * (gammaBound(2) * maxX * maxY + deltaY * maxX + deltaX * maxY);
  return t > 3 * (gammaBound(3) * maxE * maxZ + deltaE * maxZ + deltaZ * maxE) * abs(inverse);
}

/// Replaces `hit` where the ray hits the triangle in (0, hit.t).
RL_HD inline void intersect(const Triangle& triangle, const RayShear& shear, std::uint32_t id, Hit& hit) {
  Vec3 const p = shear(triangle.a), q = shear(triangle.b), r = shear(triangle.c);
  Real u = edge(r, q), v = edge(p, r), w = edge(q, p);
  if (u == 0 || v == 0 || w == 0) {  // by rounding, perhaps: small triangles far to the side would count as hit
    u = edgeExact(r, q);
    v = edgeExact(p, r);
    w = edgeExact(q, p);
  }
  if (mixedSigns(minOf(u, minOf(v, w)), maxOf(u, maxOf(v, w)))) return;
  Real t, inverse;
  if (hitTriangle(shear, p, q, r, u, v, w, hit, id, t, inverse)) hit = Hit{t, id, v * inverse, w * inverse};
}

/// Below this cosine between ray and normal the plane's t may lie outside the quad's box.
inline constexpr Real grazingCosine = Real(1e-3);

/// t moved into the ray's passage through the quad's box, so that no structure over boxes can lose the hit.
RL_HD inline Real withinBox(const Quad& quad, const Ray& ray, Real t) {
  Real enter = 0, leave = infinity;
  for (int k = 0; k < 3; ++k) {
    Real const d = RayShear::pick(ray.direction, k), o = RayShear::pick(ray.origin, k);
    if (d == 0) continue;
    Real const t0 = (RayShear::pick(quad.a, k) - o) / d, t1 = (RayShear::pick(quad.b, k) - o) / d;
    Real const t2 = (RayShear::pick(quad.c, k) - o) / d, t3 = (RayShear::pick(quad.d, k) - o) / d;
    enter = maxOf(enter, minOf(minOf(t0, t1), minOf(t2, t3)));
    leave = minOf(leave, maxOf(maxOf(t0, t1), maxOf(t2, t3)));
  }
  return minOf(maxOf(t, enter), leave);
}

/// The plane's distance first, which rules out most quads; then the watertight test of the four edges. u, v:
/// coordinates along b − a and d − a, from the half of the quad that the ray hits.
RL_HD inline void intersect(const Quad& quad, const Ray& ray, const RayShear& shear, std::uint32_t id, Hit& hit) {
  Vec3 const toPlane = quad.a - ray.origin;
  Real const slope = dot(quad.n, ray.direction), inverse = 1 / slope;
  Real t = dot(quad.n, toPlane) * inverse;
  bool const grazing = abs(slope) < grazingCosine * maxAbs(ray.direction);
  if (!(t > 0) || !(grazing || hit.improvedBy(t, id))) return;
  // Rounding of the dot product, of the normal and of the corners: within it the ray starts on the plane.
  if (t <= gammaBound(10) * dot(absolute(quad.n), absolute(toPlane)) * abs(inverse)) return;
  Vec3 const a = shear(quad.a), b = shear(quad.b), c = shear(quad.c), d = shear(quad.d);
  Real ab = edge(b, a), bc = edge(c, b), cd = edge(d, c), da = edge(a, d), ac = edge(a, c);
  if (ab == 0 || bc == 0 || cd == 0 || da == 0) {  // as for triangles
    ab = edgeExact(b, a);
    bc = edgeExact(c, b);
    cd = edgeExact(d, c);
    da = edgeExact(a, d);
    ac = edgeExact(a, c);
  }
  Real const highest = maxOf(maxOf(ab, bc), maxOf(cd, da));
  if (mixedSigns(minOf(minOf(ab, bc), minOf(cd, da)), highest)) return;
  if (grazing) {
    t = withinBox(quad, ray, t);
    if (!(t > 0) || !hit.improvedBy(t, id)) return;
  }
  bool const firstHalf = highest > 0 ? ac >= 0 : ac <= 0;
  Real const det = firstHalf ? ab + bc + ac : cd + da - ac;
  if (det == 0) return;
  hit = firstHalf ? Hit{t, id, (ac + ab) / det, ab / det} : Hit{t, id, da / det, (da - ac) / det};
}

/// Roots of |o + t d|² = 1 without cancellation (Haines et al. 2019, Ray Tracing Gems, ch. 7).
RL_HD inline bool unitSphereRoots(Vec3 o, Vec3 d, Real& t0, Real& t1) {
  Real const a = dot(d, d), b = -dot(o, d);
  Real const discriminant = 1 - lengthSquared(o + d * (b / a));
  if (!(discriminant >= 0)) return false;
  Real const q = b + copysign(sqrt(a * discriminant), b);
  Real const r0 = (dot(o, o) - 1) / q, r1 = q / a;
  t0 = minOf(r0, r1);
  t1 = maxOf(r0, r1);
  return true;
}

RL_HD inline void intersect(const Sphere& sphere, const Ray& ray, std::uint32_t id, Hit& hit) {
  Real t0, t1;
  if (!unitSphereRoots(sphere.toObject * (ray.origin - sphere.center), sphere.toObject * ray.direction, t0, t1)) return;
  Real const t = t0 > 0 ? t0 : t1;
  if (t > 0 && hit.improvedBy(t, id)) hit = Hit{t, id, 0, 0};
}

}  // namespace ropelight::RL_TARGET
