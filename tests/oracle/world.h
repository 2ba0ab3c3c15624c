#pragma once
// The oracle's random numbers, its lights and its flattened scene.

#include <cstdint>

#include "tests/oracle/geometry.h"

namespace oracle {

/// SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators").
struct Random {
  std::uint64_t state;

  std::uint64_t bits() {
    std::uint64_t z = state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  double next() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
};

/// A point chosen uniformly by area on a light that was chosen by its power.
struct LightPoint {
  int shape;
  Vec point, normal;
};

struct Light {
  int shape;
  double cumulative;  ///< probability of this light or one before it
};

struct World {
  std::vector<Shape> shapes;
  Shapes search;
  std::vector<Light> lights;
  std::vector<double> areaPdf;  ///< per shape: density of LightPoint on its area, 1/m²

  /// Throws std::invalid_argument where a shape has no area.
  explicit World(Scene const& scene);

  /// Radiance that a shape emits from a point whose front-facing normal makes this cosine with the outgoing direction.
  Rgb emitted(int shape, double cosine) const {
    Emission const& e = shapes[static_cast<std::size_t>(shape)].emission;
    bool const shines = e.side == Side::both || (cosine > 0) == (e.side == Side::front);
    return shines ? e.radiance : Rgb{};
  }

  /// Needs at least one light.
  LightPoint sampleLight(Random& random) const;
};

}  // namespace oracle
