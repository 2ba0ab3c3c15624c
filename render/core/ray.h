#pragma once
// Rays and hits.

#include "render/core/numeric.h"

namespace ropelight::RL_TARGET {

inline constexpr std::uint32_t noPrimitive = 0xFFFFFFFFu;

/// Points are origin + t·direction for t in (0, tMax]; the direction need not have unit length.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  Real tMax = infinity;
};

/// The closest hit so far. u, v: barycentrics of the second and third vertex of a triangle or half-quad.
struct Hit {
  Real t = infinity;
  std::uint32_t primitive = noPrimitive;
  Real u = 0, v = 0;

  RL_HD bool found() const { return primitive != noPrimitive; }
  /// Ties go to the lowest primitive, so that every structure gives the same answer.
  RL_HD bool improvedBy(Real candidate, std::uint32_t id) const {
    return candidate < t || (candidate == t && id < primitive);
  }
};

}  // namespace ropelight::RL_TARGET
