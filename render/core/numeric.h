#pragma once
// Floating-point tools: error bounds, ray offsets, compensated sums.

#include <cmath>
#include <cstring>
#include <limits>

#include "render/core/vec.h"

namespace ropelight::RL_TARGET {

inline constexpr Real pi = Real(3.14159265358979323846);
inline constexpr Real invPi = Real(0.31830988618379067154);
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
inline constexpr Real machineEpsilon = std::numeric_limits<Real>::epsilon() / 2;

/// Bound on the relative error of n roundings: nε/(1 − nε) (Higham 2002, Lemma 3.1).
RL_HD constexpr Real gammaBound(int n) { return (n * machineEpsilon) / (1 - n * machineEpsilon); }

RL_HD inline bool isFinite(Real x) { return x - x == 0; }
RL_HD inline bool isFinite(Vec3 v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }
RL_HD inline Real square(Real x) { return x * x; }
RL_HD inline Real maxAbs(Vec3 v) { return maxOf(maxOf(abs(v.x), abs(v.y)), abs(v.z)); }
RL_HD inline Vec3 absolute(Vec3 v) { return Vec3(abs(v.x), abs(v.y), abs(v.z)); }
RL_HD inline Real lengthSquared(Vec3 v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

/// p moved along n by a distance, and by at least one step of each coordinate.
RL_HD inline Vec3 moveAlong(Vec3 p, Vec3 n, Real distance) {
  Vec3 const offset = n * distance, o = p + offset;
  Vec3 const rounding = (2 * machineEpsilon) * absolute(o);
  return o + Vec3(copysign(rounding.x, offset.x), copysign(rounding.y, offset.y), copysign(rounding.z, offset.z));
}

/// Moves a computed surface point off its surface to the side of w, past the bound on its error (pbrt-3, §3.9.5).
/// p, error in scene units; n unit length.
RL_HD inline Vec3 offsetRayOrigin(Vec3 p, Vec3 error, Vec3 n, Vec3 w) {
  if (faulty(Fault::rayOrigin)) return p;
  Real const distance = dot(absolute(n), error);
  return moveAlong(p, n, dot(w, n) < 0 ? -distance : distance);
}

/// The same for an end of a segment whose other end is at p + w: by no more than 0.4 of the way along the normal, so
/// that the two ends never pass each other.
RL_HD inline Vec3 offsetSegmentEnd(Vec3 p, Vec3 error, Vec3 n, Vec3 w) {
  if (faulty(Fault::segmentEnd)) return p;
  Real const along = dot(w, n), distance = minOf(dot(absolute(n), error), Real(0.4) * abs(along));
  return moveAlong(p, n, along < 0 ? -distance : distance);
}

}  // namespace ropelight::RL_TARGET
