#pragma once
// What every BSDF answers. Directions are unit vectors in the local frame whose +z is the surface's outward geometric
// normal; both point away from the surface, wo back along the path that is being traced.

#include "render/core/vec.h"

namespace ropelight::RL_TARGET {

/// What a path carries: radiance from the camera, flux from a light. Refraction treats them differently.
enum class Transport : std::uint8_t { radiance, flux };

/// What a BSDF scatters, as bits.
namespace lobe {
inline constexpr std::uint32_t diffuse = 1;       ///< the same radiance to all sides: photons count by one weight
inline constexpr std::uint32_t glossy = 2;        ///< more into some directions: each photon is weighted by its own
inline constexpr std::uint32_t specular = 4;      ///< into single directions
inline constexpr std::uint32_t transmission = 8;  ///< to the other side
inline constexpr std::uint32_t gathered = diffuse | glossy;  ///< photons are stored, and light sampled, for these alone
}  // namespace lobe

/// Every BSDF has eval, pdf, sample, directionalAlbedo(wo), which is the share of light from wo that it scatters to all
/// sides, and says what it scatters: possibleLobes of any of its kind, lobes() with its parameters.
struct BsdfSample {
  Vec3 wi{0, 0, 1};
  Rgb weight{0.0f};         ///< f·|cos θ_i| / pdf
  Real pdf = 0;             ///< per solid angle; for specular lobes the probability of the lobe
  std::uint32_t lobes = 0;  ///< the one that was sampled
  Real radianceScale = 1;   ///< (η_i/η_t)² of a refraction, which roulette must not take for absorption

  RL_HD bool specular() const { return (lobes & lobe::specular) != 0; }
};

}  // namespace ropelight::RL_TARGET
