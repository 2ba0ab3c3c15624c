#pragma once
// The kernels that are compiled: every stage that depends on the scene, once for each row of features. Rows go from
// small to large; the first that covers a scene is taken, and the last covers everything, so that correctness never
// depends on this table.

#include <iterator>

#include "render/core/features.h"

#define RL_ROWS(X) X(basic) X(mesh) X(full) X(coincident)

namespace ropelight {

struct KernelRow {
  const char* name;
  FeatureBits covers;
};

namespace row {
/// Boxes, quads and spheres, tested one by one, seen through a pinhole.
inline constexpr FeatureBits basic =
    feature::all & ~(feature::triangles | feature::instances | feature::tree | feature::shortStack | feature::bvh |
                     feature::lens | feature::coincident);
/// Everything but instances through the bounding-volume hierarchy.
inline constexpr FeatureBits mesh =
    feature::all & ~(feature::tree | feature::shortStack | feature::instances | feature::coincident);
inline constexpr FeatureBits full = feature::all & ~feature::coincident;
/// Everything. Apart, since looking for surfaces at the same place costs registers.
inline constexpr FeatureBits coincident = feature::all;
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
