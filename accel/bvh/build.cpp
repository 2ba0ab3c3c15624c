#include "accel/bvh/build.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>

#include "accel/bvh/tree.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

constexpr std::uint32_t mostPrimitives = 1u << 27;  ///< BvhChild has 28 bits for items and nodes

Bvh<2> build(const FlatScene& scene, const BvhConfig& config) {
  bvh::Primitives const primitives = bvh::preparePrimitives(scene);
  bvh::Tree tree = bvh::split(primitives, config);
  bvh::reinsert(tree, config.reinsertion);
  return bvh::layOut(tree, primitives, config);
}

}  // namespace

Bvh<2> buildBvh(const FlatScene& scene, const BvhConfig& config) {
  if (scene.primitiveCount() > mostPrimitives)
    throw Error(
        fmt::format("{} primitives; a BVH holds at most 2^27: use another accelerator", scene.primitiveCount()));
  using namespace oneapi::tbb;
  auto const start = std::chrono::steady_clock::now();
  global_control const limit(global_control::max_allowed_parallelism,
                             std::size_t(std::max(config.threads, info::default_concurrency())));
  task_arena arena(config.threads > 0 ? config.threads : task_arena::automatic);
  Bvh<2> bvh = arena.execute([&] { return build(scene, config); });
  bvh.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return bvh;
}

}  // namespace ropelight
