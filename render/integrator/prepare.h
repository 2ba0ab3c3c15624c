#pragma once
// What the host does once before any backend: flatten, decide features, resolve automatic settings, build the tree.

#include "accel/kd_build.h"
#include "render/integrator/integrator.h"
#include "render/scene/flatten.h"

namespace ropelight {

/// Up to this many primitives testing all of them is faster than a tree (provisional: docs/decisions.md).
inline constexpr std::uint32_t bruteForceLimit = 24;

struct Prepared {
  FlatScene flat;
  CameraDesc camera;
  Settings settings;  ///< resolved: no zero that means 'automatic' is left
  FeatureBits features = 0;
  KdTree tree;  ///< empty without feature::tree
  BackendChoice backend;
};

/// The whole table of features: the scene's, and those that the settings add or make unnecessary.
FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& settings);

/// Throws Error (usage) where settings contradict each other or name something unknown.
Prepared prepare(const Scene& scene, const Settings& settings, const BackendChoice& backend);

/// Gather radius of iteration i = 1, 2, …: r_i² = r_1² Γ(i+α) / (Γ(1+α) Γ(i+1)), the closed form of
/// r²_{i+1} = r²_i (i+α)/(i+1) (Knaus & Zwicker 2011, eq. 20), never below `floor`.
double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor);

}  // namespace ropelight
