#pragma once
// A stored photon, in two parts: what every query tests, and what is read only of photons that are taken.

#include "render/core/numeric.h"

namespace ropelight::RL_TARGET {

/// Octahedral encoding of a unit vector in 2×16 bits (Cigolle et al. 2014); the error is below 10⁻⁴ rad.
RL_HD inline std::uint32_t packDirection(Vec3 v) {
  Real const scale = 1 / (abs(v.x) + abs(v.y) + abs(v.z));
  Real x = v.x * scale, y = v.y * scale;
  if (v.z < 0) {
    Real const fold = (1 - abs(y)) * copysign(Real(1), x);
    y = (1 - abs(x)) * copysign(Real(1), y);
    x = fold;
  }
  auto const quantise = [](Real t) { return std::uint32_t((t * Real(0.5) + Real(0.5)) * Real(65535) + Real(0.5)); };
  return quantise(x) << 16 | quantise(y);
}

/// The direction at a length of 1/√3 to 1: on the octahedron |x| + |y| + |z| = 1.
RL_HD inline Vec3 unpackOctahedron(std::uint32_t bits) {
  Real x = Real(bits >> 16) * Real(2.0 / 65535) - 1, y = Real(bits & 0xFFFFu) * Real(2.0 / 65535) - 1;
  Real const z = 1 - abs(x) - abs(y);
  if (z < 0) {
    Real const fold = (1 - abs(y)) * copysign(Real(1), x);
    y = (1 - abs(x)) * copysign(Real(1), y);
    x = fold;
  }
  return Vec3(x, y, z);
}

RL_HD inline Vec3 unpackDirection(std::uint32_t bits) { return normalize(unpackOctahedron(bits)); }

/// What the distance test reads. normal: packed, on the side that the photon arrived from.
struct alignas(16) PhotonPosition {
  Vec3 p;
  std::uint32_t normal;
};

/// What an accepted photon adds. flux: watts.
struct alignas(16) PhotonPower {
  static constexpr std::uint32_t causticBit = 0x80000000u;

  Rgb flux;
  std::uint32_t path = 0;  ///< edges from the light, and causticBit: all bounces before were specular, at least one

  RL_HD std::uint32_t edges() const { return path & ~causticBit; }
  RL_HD bool caustic() const { return (path & causticBit) != 0; }
};

/// As it lies before sorting: one sector of memory, since sorting fetches photons at random.
struct alignas(32) Photon {
  PhotonPosition position;
  PhotonPower power;
};

}  // namespace ropelight::RL_TARGET
