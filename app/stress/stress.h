#pragma once
// `ropelight stress`: whether every traversal gives the right hit where tracers fail.

#include <cstdint>
#include <string>

#include "render/integrators/integrator.h"

namespace ropelight {

struct StressOptions {
  BackendChoice backend;
  std::uint64_t rays = 200000;  ///< a mesh
  std::uint64_t seed = 1;
  bool full = false;  ///< a mesh of a million triangles too
  std::string mesh;   ///< an OBJ file to be added; empty: none
  std::string json;   ///< file for the figures, "-" for standard output; empty: none
};

/// Returns the exit code: 6 where a hit is wrong or a ray escapes from a closed mesh.
int runStress(const StressOptions& options);

}  // namespace ropelight
