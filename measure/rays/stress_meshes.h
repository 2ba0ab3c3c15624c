#pragma once
// Meshes on which structures and tracers fail.

#include <string>
#include <vector>

#include "render/flat/flat_scene.h"

namespace ropelight {

struct StressMesh {
  std::string name;
  std::vector<FlatTriangle> triangles;
  /// Radius of a ball around the origin from which every ray hits the mesh; 0 where it is not closed.
  double insideRadius = 0;
};

/// Closed, scattered, degenerate, coincident, flat, needle-shaped, tiny and far meshes; `large` adds one of a million
/// triangles.
std::vector<StressMesh> stressMeshes(bool large);

}  // namespace ropelight
