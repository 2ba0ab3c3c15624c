#pragma once
// The parts of a scene that depend on few settings, kept for the integrators that are still to come.

#include <deque>
#include <memory>
#include <mutex>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "render/flatten/flatten.h"
#include "render/prepare/shared_scene.h"

namespace ropelight {

class SceneCache {
 public:
  explicit SceneCache(const Scene& scene);

  /// The flat scene, whose reach covers the camera. One that covers more replaces it, with room to spare, where the
  /// camera has gone farther out than the scene's own.
  std::shared_ptr<const FlatScene> flat(const CameraDesc& camera);
  /// Built now, or one of the latest few. Waits for a tree that another thread is building.
  std::shared_ptr<const KdTree> tree(const std::shared_ptr<const FlatScene>& flat, const KdConfig& config);
  std::shared_ptr<const Bvh<2>> bvh(const std::shared_ptr<const FlatScene>& flat, const BvhConfig& config);
  /// The same, one for each instanced mesh. They outlast a flat scene that covers more, which has the same
  /// meshes.
  std::shared_ptr<const std::vector<KdTree>> meshTrees(const FlatScene& flat, const KdConfig& config);
  std::shared_ptr<const std::vector<Bvh<2>>> meshBvhs(const FlatScene& flat, const BvhConfig& config);

 private:
  using Meshes = std::vector<std::shared_ptr<const FlatScene>>;

  template <class Of, class Structure, class Config>
  struct Entry {
    Of of;
    Config config;
    std::shared_ptr<const Structure> structure;
  };
  template <class Of, class Structure, class Config>
  using Latest = std::deque<Entry<Of, Structure, Config>>;
  static constexpr std::size_t kept = 3;

  template <class Of, class Structure, class Config, class Build>
  std::shared_ptr<const Structure> find(Latest<Of, Structure, Config>& latest, const Of& of, const Config& config,
                                        Build&& build);

  std::mutex mutex_, building_;
  std::shared_ptr<const FlatScene> flat_;
  Latest<std::shared_ptr<const FlatScene>, KdTree, KdConfig> trees_;
  Latest<std::shared_ptr<const FlatScene>, Bvh<2>, BvhConfig> hierarchies_;
  Latest<Meshes, std::vector<KdTree>, KdConfig> meshTrees_;
  Latest<Meshes, std::vector<Bvh<2>>, BvhConfig> meshHierarchies_;
};

}  // namespace ropelight
