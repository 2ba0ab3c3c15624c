#pragma once
// An orthonormal frame around a unit normal.

#include "render/core/numeric.h"

namespace ropelight::RL_TARGET {

/// Branchless basis of Duff et al. 2017, "Building an Orthonormal Basis, Revisited". n must have unit length.
struct Frame {
  Vec3 s, t, n;

  RL_HD explicit Frame(Vec3 normal) : n(normal) {
    Real const sign = copysign(Real(1), n.z);
    Real const a = -1 / (sign + n.z);
    Real const b = n.x * n.y * a;
    s = Vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    t = Vec3(b, sign + n.y * n.y * a, -n.y);
  }

  RL_HD Vec3 toLocal(Vec3 w) const { return Vec3(dot(w, s), dot(w, t), dot(w, n)); }
  RL_HD Vec3 toWorld(Vec3 w) const { return s * w.x + t * w.y + n * w.z; }
};

}  // namespace ropelight::RL_TARGET
