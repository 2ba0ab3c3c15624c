#pragma once
// Triangulation of an outline in the plane, on whole numbers, so that every sign is exact.

#include <cstdint>
#include <vector>

#include "render/core/vec.h"

namespace ropelight {

struct GridPoint {
  std::int64_t x = 0, y = 0;  ///< within [−gridReach, gridReach]
  bool operator==(const GridPoint&) const = default;
};

inline constexpr std::int64_t gridReach = std::int64_t(1) << 43;

/// Appends triangles, as indices into the outline, that turn counter-clockwise as it does: n − 2 less those that have
/// no area. The outline may touch itself and run along itself, as it does on the way to a hole and back; corners on a
/// line are kept as corners. Distances of up to `tolerance` may be due to rounding. False where the outline must cross
/// itself; the triangles then are arbitrary, but the call ends. (Meisters 1975, "Polygons have ears".)
bool clipEars(const std::vector<GridPoint>& outline, double tolerance, std::vector<glm::uvec3>& triangles);

/// Whether two edges cross, each going through to the other's far side by more than the tolerance. Of outlines that
/// have more than some 10⁸ pairs of edges side by side, not all are looked at.
bool crossesItself(const std::vector<GridPoint>& outline, double tolerance);

}  // namespace ropelight
