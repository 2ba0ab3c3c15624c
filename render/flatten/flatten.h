#pragma once
// From a scene to its flat form: shapes become primitives, the frame moves to where floats are dense.

#include "render/flat/flat_scene.h"
#include "render/scene/ellipsoid.h"

namespace ropelight {

/// Which meshes are instanced; the triangles of all others are copied into the world, which is faster to trace.
enum class Instancing : std::uint8_t {
  automatic,  ///< those whose copies would be many triangles
  always,     ///< every mesh, except where it touches another surface (so with automatic)
  never,
};

/// Triangles that instancing a mesh must save before it is done. Provisional: on a CPU with the BVH, instanced meshes
/// of 600 to 400,000 triangles are traced at 0.9 to 1.9 times the rate of their copies; on a GPU it is not measured.
inline constexpr std::uint64_t leastSpared = 1000;

/// Where rounding in a mesh's space grows by more than this on the way to the world, the mesh is copied: the largest
/// row sum of |M|·|M⁻¹|, M being the linear part. 3 at most for rotations of any scales along the mesh's own axes.
inline constexpr double maxInstanceGrowth = 64;

/// Moves a scene that was flattened in the file's coordinates to its frame; fills origin and bounds.
void moveToFrame(FlatScene& flat);

/// Throws Error where numbers leave the range of float, there are more than 2³⁰ primitives, or more than 2³² − 1 things
/// to hit.
FlatScene flatten(const Scene& scene, Instancing instancing = Instancing::automatic);

/// What the scene alone needs; settings are added in prepare.cpp.
FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera);

}  // namespace ropelight
