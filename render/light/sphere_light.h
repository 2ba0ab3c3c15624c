#pragma once
// Sampling an ellipsoid: by area for emission, by the solid angle of its sphere in object space for direct light.

#include "render/core/frame.h"
#include "render/core/rng.h"
#include "render/core/warp.h"
#include "render/flat/flat_scene.h"
#include "render/intersection/surface.h"
#include "render/light/receiver.h"

namespace ropelight::RL_TARGET {

struct SphereLight {
  static constexpr FeatureBits bit = feature::spheres;

  /// Whether the primitive that emits is of this shape.
  static bool holds(const FlatScene& flat, std::uint32_t primitive) {
    return primitive >= flat.quads.size() && primitive - flat.quads.size() < flat.spheres.size();
  }

  RL_HD static const Sphere& shape(const SceneView& scene, const Light& light) {
    return scene.spheres[light.primitive - scene.quads.size];
  }

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

  /// A point that the receiver may see, and its density per solid angle there; 0 where there is none. toward: from the
  /// receiver to the point, scene units, from the sampled direction: of a small sphere the point itself is too coarse.
  RL_HD static Real sampleToward(const Sphere& sphere, Real /*area*/, const Receiver& from, Vec2 u, Surface& out,
                                 Vec3& toward) {
    Vec3 const o = sphere.toObject * (from.p - sphere.center);
    Real const distance2 = lengthSquared(o);
    bool const inside = from.onLight || distance2 < 1;
    Seen const seen = inside ? seenFromWithin(o, u) : seenFromOutside(o, distance2, u);
    if (!(seen.t > 0)) return 0;
    placeOn(sphere, seen.point, out);
    toward = (sphere.toWorld * seen.direction) * seen.t;
    return objectPdf(distance2, inside) * solidAngleRatio(sphere, seen.direction);
  }

  /// Density per solid angle of sampleToward for the point `on`, at `toward` from the receiver. Which side of the light
  /// was met tells whether the receiver is inside.
  RL_HD static Real pdfToward(const Sphere& sphere, Real /*area*/, Vec3 from, const Surface& on, Vec3 toward) {
    Vec3 const o = sphere.toObject * (from - sphere.center);
    return objectPdf(lengthSquared(o), dot(on.n, toward) > 0) *
           solidAngleRatio(sphere, normalize(sphere.toObject * toward));
  }

 private:
  /// In object space: a point of the unit sphere, at t·direction from the receiver; direction has unit length.
  struct Seen {
    Vec3 point, direction;
    Real t;
  };

  RL_HD static Seen seenFromWithin(Vec3 o, Vec2 u) {
    Vec3 const d = uniformSphere(u);
    Real const b = -dot(o, d);
    Real const t = b + sqrt(maxOf(Real(0), b * b - (lengthSquared(o) - 1)));
    return {o + d * t, d, t};
  }

  /// Around the axis towards the receiver at distance D: a direction of sin θ = x/D passes the centre at the distance
  /// x, and meets the sphere at height x²/D + cos θ √(1 − x²). No term grows with D, so that nothing cancels.
  RL_HD static Seen seenFromOutside(Vec3 o, Real distance2, Vec2 u) {
    Real const distance = sqrt(distance2), h = u.x * coneHeight(distance2);  // h = 1 − cos θ
    Real const x2 = minOf(distance2 * h * (2 - h), Real(1)), x = sqrt(x2), root = sqrt(1 - x2);
    Real const cosTheta = 1 - h, phi = 2 * pi * u.y;
    Frame const axis(o * (1 / distance));
    Vec3 const around = axis.s * cos(phi) + axis.t * sin(phi);
    Vec3 const point = axis.n * (x2 / distance + cosTheta * root) + around * (x * (cosTheta - root / distance));
    return {point, around * (x / distance) - axis.n * cosTheta, (distance2 - 1) / (distance * cosTheta + root)};
  }

  /// 1 − cos of the half-angle under which the unit sphere is seen from a distance of at least 1.
  RL_HD static Real coneHeight(Real distance2) {
    Real const sin2 = minOf(1 / distance2, Real(1));
    return faulty(Fault::lampCone) ? 1 - sqrt(1 - sin2) : sin2 / (1 + sqrt(1 - sin2));
  }

  RL_HD static Real objectPdf(Real distance2, bool inside) {
    return inside ? invPi / 4 : uniformConePdf(coneHeight(distance2));
  }

  /// dω_object/dω_world along a unit object-space direction: |M w|³/|det M|, as a determinant of numbers near one.
  RL_HD static Real solidAngleRatio(const Sphere& sphere, Vec3 w) {
    return abs(determinant(sphere.toObject * sqrt(lengthSquared(sphere.toWorld * w))));
  }
};

}  // namespace ropelight::RL_TARGET
