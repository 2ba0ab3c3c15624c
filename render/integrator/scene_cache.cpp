#include "render/integrator/scene_cache.h"

#include <algorithm>

namespace ropelight {

SceneCache::SceneCache(const Scene& scene) : flat_(std::make_shared<const FlatScene>(flatten(scene))) {}

std::shared_ptr<SceneCache> makeSceneCache(const Scene& scene) { return std::make_shared<SceneCache>(scene); }

std::shared_ptr<const FlatScene> SceneCache::flat(const CameraDesc& camera) {
  std::lock_guard const lock(mutex_);
  double const needed = reachOf(flat_->bounds, camera.position);
  if (needed > flat_->reach) {
    auto farther = std::make_shared<FlatScene>(*flat_);
    farther->reach = 4 * needed;
    flat_ = std::move(farther);
  }
  return flat_;
}

std::shared_ptr<const KdTree> SceneCache::tree(const std::shared_ptr<const FlatScene>& flat, const KdConfig& config) {
  std::lock_guard const lock(building_);
  auto const found =
      std::find_if(trees_.begin(), trees_.end(), [&](const Entry& e) { return e.flat == flat && e.config == config; });
  if (found != trees_.end()) return found->tree;
  trees_.push_back({flat, config, std::make_shared<const KdTree>(buildKdTree(*flat, config))});
  if (trees_.size() > kept) trees_.pop_front();
  return trees_.back().tree;
}

}  // namespace ropelight
