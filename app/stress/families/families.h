#pragma once
// The families of the catalogue. A new one is its file, a line here and a line in catalogue.cpp.

#include "app/stress/cases/case.h"

namespace ropelight::families {

struct RayOptions {
  std::uint64_t rays = 200000;  ///< a mesh
  bool full = false;            ///< a mesh of a million triangles too
  std::string mesh;             ///< an OBJ file to be added; empty: none
};

StressFamily rays(const RayOptions& options);  ///< every traversal against brute force and double precision
StressFamily transport();                      ///< many bounces, small and hidden lights, extreme ratios
StressFamily dielectrics();                    ///< glass of every index and angle
StressFamily scale();                          ///< size and place of the scene
StressFamily geometry();                       ///< degenerate, thin, touching and enclosing surfaces
StressFamily photons();                        ///< radii, counts and memory of the photon map
StressFamily length();                         ///< long runs and large counters
StressFamily files();                          ///< files as programs write them
StressFamily twin();                           ///< floats against double precision
StressFamily limits();                         ///< of film and camera

}  // namespace ropelight::families
