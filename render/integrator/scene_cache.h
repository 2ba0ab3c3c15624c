#pragma once
// The parts of a scene that depend on few settings, kept for the integrators that are still to come.

#include <deque>
#include <memory>
#include <mutex>

#include "accel/kd_build.h"
#include "render/integrator/integrator.h"
#include "render/scene/flatten.h"

namespace ropelight {

class SceneCache {
 public:
  explicit SceneCache(const Scene& scene);

  /// The flat scene, whose reach covers the camera. One that covers more replaces it, with room to spare, where the
  /// camera has gone farther out than the scene's own.
  std::shared_ptr<const FlatScene> flat(const CameraDesc& camera);
  /// Built now, or one of the latest few. Waits for a tree that another thread is building.
  std::shared_ptr<const KdTree> tree(const std::shared_ptr<const FlatScene>& flat, const KdConfig& config);

 private:
  struct Entry {
    std::shared_ptr<const FlatScene> flat;
    KdConfig config;
    std::shared_ptr<const KdTree> tree;
  };
  static constexpr std::size_t kept = 3;

  std::mutex mutex_, building_;
  std::shared_ptr<const FlatScene> flat_;
  std::deque<Entry> trees_;
};

}  // namespace ropelight
