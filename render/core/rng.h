#pragma once
// Counter-based random numbers: no state, so that any thread can compute any number of any path.

#include "render/core/vec.h"

namespace ropelight::RL_TARGET {

struct Uint4 {
  std::uint32_t x, y, z, w;
};

/// Philox4x32 with 7 rounds (Salmon et al. 2011, "Parallel Random Numbers: As Easy as 1, 2, 3"; 7 rounds pass
/// BigCrush).
RL_HD inline Uint4 philox(Uint4 c, std::uint32_t key0, std::uint32_t key1) {
  for (int round = 0; round < 7; ++round) {
    std::uint32_t const high0 = mulHigh(0xD2511F53u, c.x), low0 = 0xD2511F53u * c.x;
    std::uint32_t const high1 = mulHigh(0xCD9E8D57u, c.z), low1 = 0xCD9E8D57u * c.z;
    c = Uint4{high1 ^ c.y ^ key0, low1, high0 ^ c.w ^ key1, low0};
    key0 += 0x9E3779B9u;
    key1 += 0xBB67AE85u;
  }
  return c;
}

/// A bijection of 32-bit words that spreads every input bit (PCG's output permutation, O'Neill 2014).
RL_HD inline std::uint32_t hash32(std::uint32_t v) {
  std::uint32_t const s = v * 747796405u + 2891336453u;
  std::uint32_t const w = ((s >> ((s >> 28) + 4)) ^ s) * 277803737u;
  return (w >> 22) ^ w;
}

RL_HD inline std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b) { return hash32(a + hash32(b)); }

/// Uniform in [0, 1): never 1, whatever the rounding.
RL_HD inline Real toUnit(std::uint32_t x) {
  return Real(x >> 8) * Real(1.0 / 16777216.0);  // in double too: both precisions have the same numbers
}

}  // namespace ropelight::RL_TARGET
