#pragma once
// A photon as a window shows it.

#include <cstdint>

namespace ropelight {

/// A photon as a vertex buffer holds it, in the frame of Integrator::frameOrigin.
struct PhotonPoint {
  float position[3];
  float flux[3];          ///< watts
  std::uint32_t bounce;   ///< edges of its path from the light; 1: direct
  std::uint32_t caustic;  ///< 1 where the light reached it through specular bounces alone, at least one
};

}  // namespace ropelight
