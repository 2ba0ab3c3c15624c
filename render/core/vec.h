#pragma once
// Vectors and matrices. The only include of GLM.

#include <cmath>
#include <cstdlib>

#include "render/core/hd.h"

#if RL_CUDA_TARGET
#pragma nv_diagnostic push
#pragma nv_diag_suppress 20012  // GLM marks defaulted functions; the marks are ignored and harmless.
#endif
#include <glm/glm.hpp>
#if RL_CUDA_TARGET
#pragma nv_diagnostic pop
#endif

namespace ropelight {

/// Linear Rec. 709 RGB; the unit (radiance, flux, albedo) is said where it is used.
using Rgb = glm::vec3;
/// Host-side geometry, in scene units.
using Vec3d = glm::dvec3;
using Mat3d = glm::dmat3;
using Mat4d = glm::dmat4;

RL_HD inline float maxComponent(Rgb c) { return c.x > c.y ? (c.x > c.z ? c.x : c.z) : (c.y > c.z ? c.y : c.z); }
RL_HD inline float mean(Rgb c) { return (c.x + c.y + c.z) * (1.0f / 3.0f); }
RL_HD inline bool isBlack(Rgb c) { return c.x == 0 && c.y == 0 && c.z == 0; }

}  // namespace ropelight

namespace ropelight::RL_TARGET {

// The overloads for Real: an unqualified abs(float) would otherwise find C's abs(int).
using std::abs;
using std::atan2;
using std::copysign;
using std::cos;
using std::exp;
using std::floor;
using std::log;
using std::nextafter;
using std::pow;
using std::sin;
using std::sqrt;

// NaN in b survives, NaN in a does not; one instruction each, unlike fmin and fmax.
RL_HD inline Real minOf(Real a, Real b) { return a < b ? a : b; }
RL_HD inline Real maxOf(Real a, Real b) { return a > b ? a : b; }

using Vec2 = glm::vec<2, Real, glm::defaultp>;
using Vec3 = glm::vec<3, Real, glm::defaultp>;
using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;

}  // namespace ropelight::RL_TARGET
