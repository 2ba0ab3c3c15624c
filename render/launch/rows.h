#pragma once
// The kernels that are compiled: every stage that depends on the scene, once for each row of features. Rows go from
// small to large; the first that covers a scene is taken, and the last covers everything, so that correctness never
// depends on this table.

#include <iterator>
#include <string_view>

#include "render/core/features.h"

#define RL_ROWS(X) X(basic) X(mesh) X(touching) X(touching_mesh) X(full) X(all)

namespace ropelight {

struct KernelRow {
  const char* name;
  FeatureBits covers;
};

namespace row {
inline constexpr FeatureBits kdTrees = feature::tree | feature::shortStack;
/// Boxes, quads and spheres, tested one by one, seen through a pinhole.
inline constexpr FeatureBits basic = feature::all & ~(kdTrees | feature::triangles | feature::instances | feature::bvh |
                                                      feature::lens | feature::coincident);
/// Triangles, a BVH over all primitives, a lens.
inline constexpr FeatureBits mesh = feature::all & ~(kdTrees | feature::instances | feature::coincident);
/// The basic row where surfaces lie at the same place.
inline constexpr FeatureBits touching = basic | feature::coincident;
/// The same with meshes.
inline constexpr FeatureBits touching_mesh = mesh | feature::coincident;
/// Instances, through a BVH of two levels.
inline constexpr FeatureBits full = mesh | feature::instances;
/// Everything, kd-trees included, which are there to be compared with and looked at.
inline constexpr FeatureBits all = feature::all;

/// A stage that runs faster in a row where more of it fits on a multiprocessor than the compiler would have it.
struct Residency {
  std::string_view stage;
  FeatureBits features;
  int blocks;
};

/// Measured on an H100 (docs/benchmarks/rooms.md): 6 blocks leave a kernel 80 registers, 5 leave 96.
inline constexpr Residency measured[] = {{"TraceCamera", basic, 6},
                                         {"TraceCamera", mesh, 6},
                                         {"TracePath", basic, 5},
                                         {"TracePath", mesh, 5},
                                         {"TracePhotons", mesh, 6}};

/// Blocks of 128 threads that a GPU's multiprocessor must hold at once: 4 leave a kernel 128 registers. Rows whose
/// kernels would take more are bounded; where nothing was measured, the others are left to the compiler (0).
constexpr int blocks(std::string_view stage, FeatureBits features) {
  for (const Residency& r : measured)
    if (r.stage == stage && r.features == features) return r.blocks;
  bool const touchingMeshes = (features & feature::coincident) != 0 && (features & feature::bvh) != 0;
  return touchingMeshes || (features & (feature::instances | kdTrees)) != 0 ? 4 : 0;
}
}  // namespace row

inline constexpr KernelRow kernelRows[] = {
#define RL_ROW(name) {#name, row::name},
    RL_ROWS(RL_ROW)
#undef RL_ROW
};

/// Index in kernelRows of the first row that covers these features.
constexpr int rowFor(FeatureBits features) {
  for (int i = 0; i < int(std::size(kernelRows)); ++i)
    if ((features & ~kernelRows[i].covers) == 0) return i;
  return int(std::size(kernelRows)) - 1;
}

}  // namespace ropelight
