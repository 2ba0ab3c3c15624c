#pragma once
// Instanced meshes: the space in which they are stored, and their places in the world.

#include "render/flatten/flatten.h"

namespace ropelight {

/// A mesh centred and scaled by a power of two to within [−1, 1], as a scene of its own. `toGiven` leads back to the
/// space it came from: x_given = toGiven · x_kept.
struct KeptMesh {
  std::shared_ptr<const FlatScene> scene;
  Mat4d toGiven{1.0};
};

KeptMesh keepMesh(const Mesh& mesh);

/// |M|·|M⁻¹| applied to (1, 1, 1); infinite where M cannot be inverted.
Vec3d roundingGrowth(const Mat3d& m);

/// Fills bounds and slack from toWorld and the mesh; returns the surface area in the world.
double placeInstance(const FlatScene& mesh, FlatInstance& instance);

}  // namespace ropelight
