#pragma once
// Sampling an ellipsoid: by area for emission, by the solid angle of its sphere in object space for direct light.

#include "render/core/frame.h"
#include "render/core/rng.h"
#include "render/core/warp.h"
#include "render/scene/view.h"

namespace ropelight::RL_TARGET {

struct SphereLight {
  using Shape = Sphere;

  /// A point uniform by area, on the outer side: a uniform point of the unit sphere is kept in proportion to how much
  /// the map stretches area there, at least every second one for any ellipsoid (all of them for a sphere).
  RL_HD static void samplePoint(const Sphere& sphere, Vec2 u, Surface& out) {
    Vec3 local = uniformSphere(u);
    Real const limit = largestStretch(sphere);
    std::uint32_t word = hashCombine(std::uint32_t(u.x * Real(4294967040.0)), std::uint32_t(u.y * Real(4294967040.0)));
    for (int trial = 0; trial < 64; ++trial) {
      Real const stretch = sqrt(lengthSquared(transpose(sphere.toObject) * local));
      word = hash32(word + 1);
      if (toUnit(word) * limit <= stretch * Real(1.00001)) break;
      std::uint32_t const a = hash32(word ^ 0x68E31DA4u), b = hash32(word ^ 0xB5297A4Du);
      local = uniformSphere(Vec2(toUnit(a), toUnit(b)));
    }
    placeOn(sphere, local, out);
  }

  /// Upper bound on |toObjectᵀ n| over unit n: the Frobenius norm is reached only to within √3, so the largest row sum
  /// of the Gram matrix is used where it is smaller.
  RL_HD static Real largestStretch(const Sphere& sphere) {
    Mat3 const m = sphere.toObject;
    Mat3 const gram = m * transpose(m);
    Real bound = 0;
    for (int c = 0; c < 3; ++c) {
      Vec3 const column = absolute(gram[c]);
      bound = maxOf(bound, column.x + column.y + column.z);
    }
    return sqrt(bound);
  }

  RL_HD static Real sampleToward(const Sphere& sphere, Real /*area*/, Vec3 from, Vec2 u, Surface& out) {
    Vec3 const o = sphere.toObject * (from - sphere.center);
    Real const distance2 = lengthSquared(o);
    bool const inside = distance2 <= insideLimit(sphere);
    Vec3 const local =
        inside ? uniformSphere(u) : Frame(o * (-1 / sqrt(distance2))).toWorld(uniformCone(u, coneHeight(distance2)));
    Real const b = -dot(o, local);
    Real const root = sqrt(maxOf(Real(0), b * b - (distance2 - 1)));
    Real const t = inside ? b + root : b - root;
    if (!(t > 0)) return 0;
    placeOn(sphere, o + local * t, out);
    return objectPdf(distance2, inside) * solidAngleRatio(sphere, local);
  }

  RL_HD static Real pdfToward(const Sphere& sphere, Real /*area*/, Vec3 from, Vec3 p) {
    Vec3 const o = sphere.toObject * (from - sphere.center);
    Real const distance2 = lengthSquared(o);
    return objectPdf(distance2, distance2 <= insideLimit(sphere)) *
           solidAngleRatio(sphere, normalize(sphere.toObject * (p - from)));
  }

 private:
  /// 1 − cos of the half-angle under which the unit sphere is seen from a distance > 1.
  RL_HD static Real coneHeight(Real distance2) {
    Real const sin2 = 1 / distance2;
    return sin2 / (1 + sqrt(maxOf(Real(0), 1 - sin2)));
  }

  /// Squared distance from the center, in object space, up to which a computed point of the surface may lie: such a
  /// point is taken to be inside, where it may see the light it lies on.
  RL_HD static Real insideLimit(const Sphere& sphere) {
    Vec3 const c = absolute(sphere.center);
    Vec3 const offset =
        absolute(sphere.toObject[0]) * c.x + absolute(sphere.toObject[1]) * c.y + absolute(sphere.toObject[2]) * c.z;
    return 1 + gammaBound(64) * (1 + maxAbs(offset));
  }

  RL_HD static Real objectPdf(Real distance2, bool inside) {
    return inside ? invPi / 4 : uniformConePdf(coneHeight(distance2));
  }

  /// dω_object/dω_world along a unit object-space direction: |M w|³/|det M|.
  RL_HD static Real solidAngleRatio(const Sphere& sphere, Vec3 w) {
    Real const length2 = lengthSquared(sphere.toWorld * w);
    return length2 * sqrt(length2) * abs(determinant(sphere.toObject));
  }
};

}  // namespace ropelight::RL_TARGET
