#pragma once
// What every BSDF answers. Directions are unit vectors in the local frame whose +z is the surface's outward geometric
// normal; both point away from the surface, wo back along the path that is being traced.

#include "render/core/vec.h"

namespace ropelight::RL_TARGET {

/// What a path carries: radiance from the camera, flux from a light. Refraction treats them differently.
enum class Transport : std::uint8_t { radiance, flux };

/// Every BSDF has eval, pdf, sample and directionalAlbedo(wo): the share of light from wo that it scatters to all
/// sides.
struct BsdfSample {
  Vec3 wi{0, 0, 1};
  Rgb weight{0.0f};        ///< f·|cos θ_i| / pdf
  Real pdf = 0;            ///< per solid angle; for specular lobes the probability of the lobe
  Real radianceScale = 1;  ///< (η_i/η_t)² of a refraction, which roulette must not take for absorption
};

}  // namespace ropelight::RL_TARGET
