#pragma once
// Directions in which a point of a light sends photons towards specular surfaces: a mixture of cones, one a target,
// with its density, so that what is sent stays unbiased.

#include "render/core/frame.h"
#include "render/core/warp.h"
#include "render/intersection/scene_view.h"

namespace ropelight::RL_TARGET {

/// A target as a point with a normal sees it. weight: an upper bound on the cosine-weighted solid angle.
struct Aim {
  Vec3 axis;
  Real height = 0;      ///< 1 − cos of the cone's half-angle
  Real cosine = 0;      ///< largest between the normal and the cone's directions; 0: all are below the horizon
  bool around = false;  ///< the point is within the target: all directions lead there
  Real weight = 0;

  RL_HD Aim(const Target& target, Vec3 p, Vec3 n) {
    Vec3 const d = target.center - p;
    Real const distance2 = lengthSquared(d), radius2 = square(target.radius);
    around = !(distance2 > radius2 * Real(1.0001));
    if (around) {
      weight = pi;
      return;
    }
    Real const sin2 = radius2 / distance2, cosHalf = sqrt(1 - sin2);
    height = sin2 / (1 + cosHalf);
    axis = d * (1 / sqrt(distance2));
    Real const c = dot(axis, n);
    cosine = c >= cosHalf ? Real(1) : c * cosHalf + sqrt(maxOf(Real(0), 1 - c * c) * sin2);
    cosine = maxOf(cosine, Real(0));
    weight = 2 * pi * height * cosine;
  }

  /// Whether the cone holds the unit direction; |w − axis|² = 2(1 − cos) does not cancel.
  RL_HD bool holds(Vec3 w) const { return lengthSquared(w - axis) <= 2 * height; }
};

/// A direction (unit) for a photon from a point of a light with unit normal n, and the factor by which its flux differs
/// from that of a photon sent by the cosine to n: 0 where it goes nowhere. The targets hold every direction that is
/// wanted.
struct Aimed {
  Vec3 direction{0};
  Real factor = 0;
};

RL_HD inline Aimed aimAt(Span<const Target> targets, Vec3 p, Vec3 n, Real u, Vec2 uDirection) {
  Real total = 0;
  for (const Target& t : targets) total += Aim(t, p, n).weight;
  Aimed aimed;
  if (!(total > 0)) return aimed;
  Real rest = u * total;
  std::uint32_t chosen = 0;
  for (std::uint32_t k = 0; k < targets.size; ++k) {
    Real const weight = Aim(targets[k], p, n).weight;
    if (weight > 0) chosen = k;  // rounding may leave a rest after the last
    if (rest < weight) break;
    rest -= weight;
  }
  Aim const aim(targets[chosen], p, n);
  aimed.direction = normalize(aim.around ? Frame(n).toWorld(cosineHemisphere(uDirection))
                                         : Frame(aim.axis).toWorld(uniformCone(uDirection, aim.height)));
  Real const cosine = dot(aimed.direction, n);
  if (!(cosine > 0)) return aimed;
  Real density = 0;  // times the total
  for (std::uint32_t k = 0; k < targets.size; ++k) {
    Aim const other(targets[k], p, n);
    if (other.around)
      density += cosine;
    else if (k == chosen || other.holds(aimed.direction))
      density += other.cosine;
  }
  aimed.factor = cosine * total * invPi / density;
  return aimed;
}

}  // namespace ropelight::RL_TARGET
