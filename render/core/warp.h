#pragma once
// Warps of uniform numbers in [0, 1) to directions and points, with their densities.

#include "render/core/numeric.h"

namespace ropelight::RL_TARGET {

/// Uniform point on the unit disc (Shirley & Chiu 1997, concentric map).
RL_HD inline Vec2 concentricDisc(Vec2 u) {
  Real const a = 2 * u.x - 1, b = 2 * u.y - 1;
  if (a == 0 && b == 0) return Vec2(0, 0);
  Real r, phi;
  if (abs(a) > abs(b)) {
    r = a;
    phi = (pi / 4) * (b / a);
  } else {
    r = b;
    phi = pi / 2 - (pi / 4) * (a / b);
  }
  return Vec2(r * cos(phi), r * sin(phi));
}

/// Direction in z ≥ 0 with density cos θ/π per steradian (Malley's method). z is never 0, so that weights stay finite.
RL_HD inline Vec3 cosineHemisphere(Vec2 u) {
  Vec2 const d = concentricDisc(u);
  Real const z2 = 1 - d.x * d.x - d.y * d.y;
  return Vec3(d.x, d.y, sqrt(maxOf(z2, Real(1e-12))));
}

RL_HD inline Real cosineHemispherePdf(Real cosTheta) { return cosTheta * invPi; }

/// Uniform direction on the unit sphere, density 1/(4π).
RL_HD inline Vec3 uniformSphere(Vec2 u) {
  Real const z = 1 - 2 * u.x;
  Real const r = sqrt(maxOf(Real(0), 1 - z * z));
  Real const phi = 2 * pi * u.y;
  return Vec3(r * cos(phi), r * sin(phi), z);
}

/// Uniform direction in the cone around +z with 1 − cos θ_max = oneMinusCosMax (kept small without cancellation).
RL_HD inline Vec3 uniformCone(Vec2 u, Real oneMinusCosMax) {
  Real const h = u.x * oneMinusCosMax;  // 1 − cos θ
  Real const r = sqrt(maxOf(Real(0), h * (2 - h)));
  Real const phi = 2 * pi * u.y;
  return Vec3(r * cos(phi), r * sin(phi), 1 - h);
}

RL_HD inline Real uniformConePdf(Real oneMinusCosMax) { return 1 / (2 * pi * oneMinusCosMax); }

}  // namespace ropelight::RL_TARGET
