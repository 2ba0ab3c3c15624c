#pragma once
// Balls that hold every specular surface of a scene: a photon that becomes part of a caustic leaves its light towards
// one of them (projection maps: Jensen 1996, whose cells of directions are balls here).

#include <vector>

#include "render/flat/flat_scene.h"

namespace ropelight {

struct SpecularTarget {
  Vec3d center{0.0};
  double radius = 0;
};

/// Most targets of a scene; each costs every aimed photon a few operations.
inline constexpr int mostTargets = 64;

/// Balls around all mirrors and dielectrics, in the flat scene's frame; none where there are none. They may overlap.
/// Among the cuts through a tree over the surfaces they are the one that covers the least cross-section, so that a ring
/// becomes a chain of small balls and a mesh of a sphere a single one.
std::vector<SpecularTarget> specularTargets(const FlatScene& flat);

}  // namespace ropelight
