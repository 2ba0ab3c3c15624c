#include "render/prepare/scene_cache.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace ropelight {
namespace {

template <class Structure, class Config, class Build>
std::vector<Structure> forEachMesh(const FlatScene& flat, const Config& config, Build&& build) {
  std::vector<Structure> structures(flat.meshes.size());
  oneapi::tbb::this_task_arena::isolate([&] {  // under a lock: no other work may be taken up while waiting
    oneapi::tbb::parallel_for(std::size_t(0), structures.size(),
                              [&](std::size_t m) { structures[m] = build(*flat.meshes[m], config); });
  });
  return structures;
}

}  // namespace

SceneCache::SceneCache(const Scene& scene) : flat_(std::make_shared<const FlatScene>(flatten(scene))) {}

std::shared_ptr<SceneCache> makeSceneCache(const Scene& scene) { return std::make_shared<SceneCache>(scene); }

std::shared_ptr<const FlatScene> SceneCache::flat(const CameraDesc& camera) {
  std::lock_guard const lock(mutex_);
  double const needed = reachOf(flat_->bounds, flat_->inFrame(camera).position);
  if (needed > flat_->reach) {
    auto farther = std::make_shared<FlatScene>(*flat_);
    farther->reach = 4 * needed;
    flat_ = std::move(farther);
  }
  return flat_;
}

template <class Of, class Structure, class Config, class Build>
std::shared_ptr<const Structure> SceneCache::find(Latest<Of, Structure, Config>& latest, const Of& of,
                                                  const Config& config, Build&& build) {
  std::lock_guard const lock(building_);
  for (const auto& entry : latest)
    if (entry.of == of && entry.config == config) return entry.structure;
  latest.push_back({of, config, std::make_shared<const Structure>(build())});
  if (latest.size() > kept) latest.pop_front();
  return latest.back().structure;
}

std::shared_ptr<const KdTree> SceneCache::tree(const std::shared_ptr<const FlatScene>& flat, const KdConfig& config) {
  return find(trees_, flat, config, [&] { return buildKdTree(*flat, config); });
}

std::shared_ptr<const Bvh<2>> SceneCache::bvh(const std::shared_ptr<const FlatScene>& flat, const BvhConfig& config) {
  return find(hierarchies_, flat, config, [&] { return buildBvh(*flat, config); });
}

std::shared_ptr<const std::vector<KdTree>> SceneCache::meshTrees(const FlatScene& flat, const KdConfig& config) {
  return find(meshTrees_, flat.meshes, config, [&] { return forEachMesh<KdTree>(flat, config, buildKdTree); });
}

std::shared_ptr<const std::vector<Bvh<2>>> SceneCache::meshBvhs(const FlatScene& flat, const BvhConfig& config) {
  return find(meshHierarchies_, flat.meshes, config, [&] { return forEachMesh<Bvh<2>>(flat, config, buildBvh); });
}

}  // namespace ropelight
