#pragma once
// What the host does once before any backend: flatten, decide features, resolve automatic settings, build the tree.

#include <optional>

#include "render/prepare/scene_cache.h"

namespace ropelight {

struct Prepared {
  std::shared_ptr<const FlatScene> flat;
  CameraDesc camera;  ///< in the flat scene's frame
  FilmDesc film;
  Settings requested;  ///< as given
  Settings settings;   ///< resolved: no zero that means 'automatic' is left
  FeatureBits features = 0;
  std::shared_ptr<const KdTree> tree;                    ///< null without feature::tree
  std::shared_ptr<const Bvh<2>> bvh;                     ///< null without feature::bvh
  std::shared_ptr<const std::vector<KdTree>> meshTrees;  ///< one a mesh that is kept once; null without feature::tree
  std::shared_ptr<const std::vector<Bvh<2>>> meshBvhs;   ///< likewise without feature::bvh
  BackendChoice backend;                                 ///< its gpu is the one taken
  bool onGpu = false;
};

/// The integrator that makes what the settings ask for: the mode, or aov for what the first hit alone shows.
std::string integratorName(const Settings& settings);

/// The whole table of features: the scene's, and those that the settings add or make unnecessary.
FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& settings);

/// onGpu: whether backend.gpu is to be used. Throws Error: usage where settings contradict each other or name something
/// unknown, outOfMemory where they need more memory than there is.
Prepared prepare(const Scene& scene, const Settings& settings, const BackendChoice& backend, bool onGpu,
                 SceneCache& cache);

/// The same scene and tree with another camera and other settings; empty where those need another integrator. Throws
/// as prepare does.
std::optional<Prepared> prepareAgain(const Prepared& before, const CameraDesc& camera, const Settings& settings);

/// Gather radius of iteration i = 1, 2, …: r_i² = r_1² Γ(i+α) / (Γ(1+α) Γ(i+1)), the closed form of
/// r²_{i+1} = r²_i (i+α)/(i+1) (Knaus & Zwicker 2011, eq. 20), never below `floor`.
double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor);

}  // namespace ropelight
