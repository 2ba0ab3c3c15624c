#pragma once
// Random numbers for tests.

#include <random>

#include "render/core/rng.h"

namespace ropelight {

/// Fixed seeds; the same numbers everywhere, unlike the distributions of <random>.
class TestRandom {
 public:
  explicit TestRandom(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t word() { return std::uint32_t(engine_()); }
  double unit() { return word() / 4294967296.0; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::uint32_t below(std::size_t n) { return std::uint32_t(std::uint64_t(word()) * n >> 32); }
  Vec3d inBox(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  Vec3d direction() {
    double const z = between(-1, 1), phi = between(0, 2 * M_PI), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  cpu::Vec2 vec2() { return {cpu::toUnit(word()), cpu::toUnit(word())}; }

 private:
  std::mt19937 engine_;
};

}  // namespace ropelight
