#pragma once
// A point that light is sampled for.

#include "render/core/vec.h"

namespace ropelight::RL_TARGET {

/// onLight: it lies on the light itself, whose inner side it may see; rounding cannot tell that from the position.
struct Receiver {
  Vec3 p{0};
  bool onLight = false;
};

}  // namespace ropelight::RL_TARGET
