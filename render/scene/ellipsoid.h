#pragma once
// The area of an ellipsoid, and how far a linear map stretches.

#include "render/core/vec.h"

namespace ropelight {

/// Surface area of the ellipsoid that a linear map makes of the unit sphere: S = 4π R_G(a²b², a²c², b²c²), with R_G by
/// Carlson's duplication (Carlson 1995, "Numerical computation of real or complex elliptic integrals").
double ellipsoidArea(const Mat3d& toWorld);

/// Singular values of a 3×3 matrix, largest first.
Vec3d singularValues(const Mat3d& m);

}  // namespace ropelight
