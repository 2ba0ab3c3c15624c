#pragma once
// Padded two-dimensional Sobol' points with hash-based Owen scrambling (Burley 2020, "Practical Hash-based Owen
// Scrambling", with the permutation of Vegdahl 2021).

#include "render/core/rng.h"

namespace ropelight::RL_TARGET {

struct SobolSampler {
  static constexpr const char* name = "sobol";

  /// Owen scrambling of a word whose most significant digit is bit 0 (that is, already bit-reversed).
  RL_HD static std::uint32_t scrambleReversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return x;
  }

  /// The bits of the second Sobol' coordinate, most significant digit in bit 0: digit k is the parity of the index bits
  /// j ⊇ k, since the generator matrix is Pascal's triangle mod 2 (Lucas' theorem).
  RL_HD static std::uint32_t pascal(std::uint32_t x) {
    x ^= (x >> 1) & 0x55555555u;
    x ^= (x >> 2) & 0x33333333u;
    x ^= (x >> 4) & 0x0F0F0F0Fu;
    x ^= (x >> 8) & 0x00FF00FFu;
    x ^= (x >> 16) & 0x0000FFFFu;
    return x;
  }

  /// Point `index` of the sequence that `seed` names; different seeds are independent scramblings.
  RL_HD static Vec2 sample(std::uint32_t index, std::uint32_t seed) {
    std::uint32_t const i = shuffle(index, seed);
    return Vec2(toUnit(reverseBits(scrambleReversed(i, seed * 0x9E3779B1u + 0x7F4A7C15u))),
                toUnit(reverseBits(scrambleReversed(pascal(i), seed * 0x85EBCA77u + 0xC2B2AE3Du))));
  }

  /// Its first coordinate alone.
  RL_HD static Real sample1(std::uint32_t index, std::uint32_t seed) {
    return toUnit(reverseBits(scrambleReversed(shuffle(index, seed), seed * 0x9E3779B1u + 0x7F4A7C15u)));
  }

 private:
  /// Owen scrambling of the index itself keeps every aligned block of 2ᵏ points together.
  RL_HD static std::uint32_t shuffle(std::uint32_t index, std::uint32_t seed) {
    return reverseBits(scrambleReversed(reverseBits(index), seed));
  }
};

}  // namespace ropelight::RL_TARGET
