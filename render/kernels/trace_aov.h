#pragma once
// What the first hit looks like, without any light (arbitrary output variables).

#include "render/backend/tally.h"
#include "render/core/frame.h"
#include "render/kernels/frame_view.h"
#include "render/settings/choices.h"

namespace ropelight::RL_TARGET {

template <FeatureBits F>
struct TraceAov;

struct TraceAovArgs {
  template <FeatureBits F>
  using Stage = TraceAov<F>;
  static constexpr const char* name = "TraceAov";
  static constexpr std::uint32_t grain = 512;

  FrameView frame;
  Aov aov;
  Span<Rgb> film;
};

template <FeatureBits F>
struct TraceAov : TraceAovArgs {
  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    int x, y;
    film[slot] = Rgb(0.0f);
    if (!frame.pixelOf(slot, x, y)) return;
    Sampler sampler = frame.cameraSampler(x, y);
    Ray const ray = frame.cameraRay<F>(x, y, sampler);
    ++tally.rays;
    film[slot] = aov == Aov::traversal || aov == Aov::tests ? cost(ray) : atHit(ray);
  }

 private:
  RL_HD Rgb atHit(const Ray& ray) const {
    Hit const hit = closestHit<F>(frame.scene, ray);
    if (!hit.found()) return Rgb(0.0f);
    if (aov == Aov::depth) return Rgb(float(hit.t));
    Surface const s = surfaceMet<F>(frame.scene, ray, hit);
    if (aov == Aov::normal) return Rgb(s.n);
    Rgb albedo(0.0f);
    bsdfAt<F>(frame.scene, s,
              [&](const auto& bsdf) { albedo = bsdf.directionalAlbedo(Frame(s.n).toLocal(-ray.direction)); });
    return albedo;
  }

  /// Primitives tested until the closest hit is known; for the traversal, with the cells or nodes that were visited.
  RL_HD Rgb cost(const Ray& ray) const {
    int visits = 0, tests = int(frame.scene.primitiveCount);
    if constexpr ((F & feature::bvh) != 0)
      if (!frame.scene.bvh.nodes.empty()) countNodes(ray, visits, tests);
    if constexpr ((F & feature::tree) != 0)
      if (!frame.scene.tree.nodes.empty()) countCells(ray, visits, tests);
    return Rgb(float(aov == Aov::traversal ? visits + tests : tests));
  }

  RL_HD void countCells(const Ray& ray, int& cells, int& tests) const {
    Hit hit;
    hit.t = ray.tMax;
    RayShear const shear(ray);
    cells = tests = 0;
    traverseTree<F>(
        frame.scene, ray,
        [&](std::uint32_t id) {
          ++tests;
          intersectPrimitive<F>(frame.scene, ray, shear, id, hit);
        },
        [&](Real t) {
          ++cells;
          return hit.t <= t;
        });
  }

  RL_HD void countNodes(const Ray& ray, int& nodes, int& tests) const {
    Hit hit;
    hit.t = ray.tMax;
    RayShear const shear(ray);
    nodes = tests = 0;
    traverseBvh(
        frame.scene.bvh, ray,
        [&](std::uint32_t item) {
          ++tests;
          intersectItem<F>(frame.scene, ray, shear, item, hit);
        },
        [&] { return hit.t; }, [&] { ++nodes; });
  }
};

}  // namespace ropelight::RL_TARGET
