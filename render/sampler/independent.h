#pragma once
// Independent uniform numbers, for checks of theory that assumes them.

#include "render/core/rng.h"

namespace ropelight::RL_TARGET {

struct IndependentSampler {
  static constexpr const char* name = "independent";

  RL_HD static Vec2 sample(std::uint32_t index, std::uint32_t path, std::uint32_t dimension, std::uint32_t key0,
                           std::uint32_t key1) {
    Uint4 const r = philox(Uint4{index, path, dimension, 0}, key0, key1);
    return Vec2(toUnit(r.x), toUnit(r.y));
  }
};

}  // namespace ropelight::RL_TARGET
