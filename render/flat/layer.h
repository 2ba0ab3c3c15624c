#pragma once
// Where a surface lies among those at the same place, within what rays can resolve: as if all were an infinitely thin
// gap apart, in an order that docs/scene-format.md states.

#include "render/core/hd.h"

namespace ropelight {

/// Of one primitive. The surfaces of a stack are numbered in the order in which a ray from the stack's front hits them,
/// and again from its back; equal numbers are one surface. Opaque surfaces lie in one plane: from each, only those of
/// lower number are seen.
struct alignas(16) Layer {
  static constexpr std::uint32_t opaqueBit = 1, flippedBit = 2;

  std::uint32_t stack = 0;  ///< number << 2, from 1 << 2; flippedBit where its normal is the stack's reversed; 0: none
  std::uint32_t fromFront = 0, fromBack = 0;
  float depth = 0;  ///< more than rounding can move any surface of the stack along the normal, scene units

  RL_HD bool stacked() const { return stack != 0; }
  RL_HD bool opaque() const { return (stack & opaqueBit) != 0; }
  RL_HD bool flipped() const { return (stack & flippedBit) != 0; }
  RL_HD bool sharesStack(const Layer& other) const { return (stack ^ other.stack) < 4 && stack != 0; }
};

}  // namespace ropelight
