#pragma once
// One stage a traversal: many rays against a scene, hits out.

#include "accel/kdtree/top.h"
#include "measure/streams/ray_stream.h"
#include "render/backend/tally.h"
#include "render/intersection/intersect.h"

namespace ropelight::RL_TARGET {

/// Rays in, hits out.
struct RayBatch {
  Span<const StreamRay> rays;
  Span<StreamHit> hits;

  RL_HD Ray ray(std::uint32_t i) const {
    StreamRay const r = rays[i];
    return Ray{Vec3(r.origin[0], r.origin[1], r.origin[2]), Vec3(r.direction[0], r.direction[1], r.direction[2]),
               r.tMax};
  }
  RL_HD void put(std::uint32_t i, const Hit& hit) const { hits[i] = {float(hit.t), hit.primitive}; }
  RL_HD void put(std::uint32_t i, bool found) const { hits[i] = {0, found ? 0u : noPrimitive}; }
};

/// Everything that the stages below share.
template <FeatureBits F, bool anyHit>
struct TraceBase {
  static constexpr std::uint32_t grain = 256;

  RayBatch batch;
  SceneView scene;
};

template <FeatureBits F, bool anyHit>
struct TraceBrute : TraceBase<F, anyHit> {
  static constexpr const char* name = "TraceBrute";

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    Ray const ray = this->batch.ray(i);
    if constexpr (anyHit)
      this->batch.put(i, occludedBruteForce<F & ~feature::bvh>(this->scene, ray, noPrimitive));
    else
      this->batch.put(i, closestHitBruteForce<F & ~feature::bvh>(this->scene, ray));
  }
};

/// By ropes or, with feature::shortStack in F, with a short stack.
template <FeatureBits F, bool anyHit>
struct TraceTree : TraceBase<F, anyHit> {
  static constexpr const char* name = "TraceTree";

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    Ray const ray = this->batch.ray(i);
    if constexpr (anyHit)
      this->batch.put(i, occludedTree<F>(this->scene, ray, noPrimitive));
    else
      this->batch.put(i, closestHitTree<F>(this->scene, ray));
  }
};

/// By ropes from a start that is found in shared memory.
template <FeatureBits F, bool anyHit>
struct TraceShared : TraceBase<F, anyHit> {
  static constexpr const char* name = "TraceShared";

  Span<const KdNode> shared;  ///< what is copied into shared memory: the tree's top

  RL_HD void operator()(std::uint32_t i, const KdNode* top, Tally&) const {
    Ray const ray = this->batch.ray(i);
    Hit hit;
    hit.t = ray.tMax;
    RayShear const shear(ray);
    auto const test = [&](std::uint32_t id) {
      if (!anyHit || !hit.found()) intersectPrimitive<F>(this->scene, ray, shear, id, hit);
    };
    auto const done = [&](Real t) { return hit.t <= t || (anyHit && hit.found()); };
    traverseRopes(this->scene.tree, ray, test, done, [&](const RayPlanes& p, Real t) { return descendTop(top, p, t); });
    if constexpr (anyHit)
      this->batch.put(i, hit.found());
    else
      this->batch.put(i, hit);
  }
};

template <FeatureBits F, bool anyHit, int W>
struct TraceBvh : TraceBase<F, anyHit> {
  static constexpr const char* name = "TraceBvh";

  BvhView<W> bvh;

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    Ray const ray = this->batch.ray(i);
    if constexpr (anyHit)
      this->batch.put(i, occludedBvh<F>(this->scene, bvh, ray, noPrimitive));
    else
      this->batch.put(i, closestHitBvh<F>(this->scene, bvh, ray));
  }
};

/// A leaf at a time, so that a warp whose rays have ended may take others in between.
template <FeatureBits F, bool anyHit>
struct TraceRefilled : TraceBase<F, anyHit> {
  static constexpr const char* name = "TraceRefilled";

  BvhView<2> bvh;

  using Stack = BvhStack;

  /// One ray under way.
  struct Lane {
    std::uint32_t index;
    Ray ray;
    RayShear shear;
    BvhWalk walk;
    Hit hit;

    RL_HD Lane() : ray{Vec3(0), Vec3(1)}, shear(ray), walk(ray) {}
  };

  RL_HD void begin(std::uint32_t i, Lane& lane) const {
    lane.index = i;
    lane.ray = this->batch.ray(i);
    lane.shear = RayShear(lane.ray);
    lane.walk = BvhWalk(lane.ray);
    lane.hit = Hit{};
    lane.hit.t = lane.ray.tMax;
  }

  /// Whether the ray goes on; where it does not, its hit is written.
  RL_HD bool step(Lane& lane, Stack& stack) const {
    bool more = lane.walk.advance(bvh, stack, lane.hit.t);
    if (more) {
      BvhChild const leaf = lane.walk.leaf();
      for (std::uint32_t k = leaf.index(), end = k + leaf.count(); k < end; ++k)
        intersectItem<F>(this->scene, lane.ray, lane.shear, k, lane.hit);
      more = !(anyHit && lane.hit.found()) && lane.walk.pop(stack, lane.hit.t);
    }
    if (more) return true;
    if constexpr (anyHit)
      this->batch.put(lane.index, lane.hit.found());
    else
      this->batch.put(lane.index, lane.hit);
    return false;
  }
};

}  // namespace ropelight::RL_TARGET
