#pragma once
// Polygons → triangles.

#include <cstdint>
#include <vector>

#include "render/core/vec.h"

namespace ropelight {

/// What a polygon turned out to be when it was cut.
struct PolygonFacts {
  double departure = 0;   ///< largest distance of a corner from the polygon's plane, over the diagonal of its bounds
  bool crossing = false;  ///< the outline crosses itself
};

/// Cuts polygons in their own plane, whose normal is Newell's (Sutherland, Sproull and Schumacker 1974, "A
/// characterization of ten hidden-surface algorithms"): the fan around the first corner where that covers the polygon
/// and nothing else, else ears (ear_clipping.h). Corners may repeat, lie on a line, or run to a hole and back.
class PolygonCutter {
 public:
  /// Appends the triangles that have an area, which turn as the polygon does; none where it has none. `corners` are
  /// indices into positions, three or more. An outline that crosses itself is cut into something with its corners.
  PolygonFacts cut(const std::vector<std::uint32_t>& corners, const std::vector<Vec3d>& positions,
                   std::vector<glm::uvec3>& triangles);

 private:
  void scale(const std::vector<std::uint32_t>& corners, const std::vector<Vec3d>& positions);
  double departure() const;
  bool fanFits() const;
  bool clip();
  void fan();
  PolygonFacts divide();

  std::vector<Vec3d> points_;       ///< the corners within [−1, 1]³ around the centre of their bounds
  double rounding_ = 0;             ///< what they may be off by
  Vec3d normal_{0.0};               ///< of length 1
  std::vector<glm::uvec3> pieces_;  ///< triangles by corner
};

}  // namespace ropelight
