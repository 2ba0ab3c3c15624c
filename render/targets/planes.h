#pragma once
// The flat surfaces on which photons are gathered: every quad, and what stands on it.

#include <vector>

#include "render/flat/flat_scene.h"

namespace ropelight {

/// A quad, or a face that stands on one: `covers` is set where it belongs to something solid, which hides the quad from
/// the side that the face's normal points away from.
struct PlanePart {
  FlatQuad quad;
  bool covers = false;
};

/// Parts [first[k], first[k + 1]) belong to quad k: itself, then the faces that stand on it.
struct PlaneParts {
  std::vector<std::uint32_t> first;
  std::vector<PlanePart> parts;
};

PlaneParts planeParts(const FlatScene& flat);

}  // namespace ropelight
