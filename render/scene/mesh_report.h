#pragma once
// What a loader had to repair, approximate or leave out of a mesh file.

#include <cstdint>
#include <string>

namespace ropelight {

/// Counts over one file; all except the first are zero where the file was taken as it is.
struct MeshReport {
  std::uint64_t polygons = 0;    ///< faces of more than three corners
  std::uint64_t notPlanar = 0;   ///< polygons that leave their plane by more than 10⁻³ of their size
  double departure = 0;          ///< the largest such distance, as a fraction of its size
  std::uint64_t crossing = 0;    ///< polygons whose outline crosses itself
  std::uint64_t degenerate = 0;  ///< faces without an area, dropped
  std::uint64_t unused = 0;      ///< vertices that no face names
  /// Triangles that single precision, from the mesh's centre, cannot tell from a line or a point.
  std::uint64_t merged = 0;
  std::uint64_t leftOut = 0;  ///< points, lines, curves and surfaces
};

/// One line for a person, "FILE: 3 of 1200 polygons are not planar …, 17 vertices belong to no face"; empty where there
/// is nothing to say.
std::string describe(const std::string& file, const MeshReport& report);

}  // namespace ropelight
