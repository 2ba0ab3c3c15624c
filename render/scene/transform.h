#pragma once
// Affine transforms of shapes (column vectors: world = M · local).

#include "render/core/vec.h"

namespace ropelight {

Mat4d translation(Vec3d offset);
Mat4d scaling(Vec3d factors);

/// Right-handed rotation around an axis through the origin (Rodrigues). The axis must not be zero.
Mat4d rotation(Vec3d axis, double degrees);

/// Where the unit quad of ShapeKind::quad goes: its third column is along edge1 × edge2 and as long as the edges'
/// geometric mean. All zero in that column where the edges are parallel.
Mat4d quadToWorld(Vec3d corner, Vec3d edge1, Vec3d edge2);

/// ‖M‖·‖M⁻¹‖/3 in the Frobenius norm: 1 for rotations and uniform scales of any size, infinite for singular matrices
/// and those that are not finite.
double conditionNumber(const Mat3d& m);

Vec3d transformPoint(const Mat4d& m, Vec3d p);
Vec3d transformVector(const Mat4d& m, Vec3d v);

/// Larger condition numbers than this leave single precision no digits to work with.
inline constexpr double maxCondition = 1e7;
/// The longest radius of an ellipsoid over the shortest: hits leave its surface by 3·10⁻⁶ of its length here, by 5·10⁻⁴
/// at ten times it. With room for the rounding of a transform that says 10⁴.
inline constexpr double maxSphereAspect = 1e4 * (1 + 1e-9);

}  // namespace ropelight
