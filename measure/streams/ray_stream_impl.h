#pragma once
// RayStream on one backend, which the including unit has included before.

#include "measure/streams/ray_stages.h"
#include "render/core/error.h"
#include "render/upload/upload.h"

namespace ropelight::RL_TARGET {

template <class Backend, FeatureBits F>
class RayStreamOn final : public RayStream {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  RayStreamOn(const StreamScene& scene, const BackendChoice& choice)
      : backend_(choice), device_(backend_, prepared(scene)) {
    backend_.timeStages(true);
    if (scene.tree) top_.copy(backend_, kdTop(*scene.tree));
    if (scene.bvh) binary_.copy(backend_, *scene.bvh);
    if (scene.wide) wide_.copy(backend_, *scene.wide);
    if (scene.bvh || scene.wide)
      items_.copy(backend_, itemTriangles(*scene.flat, scene.bvh ? scene.bvh->items : scene.wide->items));
    device_.view.bvhTriangles = items_.view();
  }

  bool supports(Traversal traversal) const override {
    switch (traversal) {
      case Traversal::brute:
        return true;
      case Traversal::ropes:
      case Traversal::ropesShared:
      case Traversal::shortStack:
        return top_.size() > 0;
      case Traversal::bvh:
      case Traversal::bvhRefill:
        return binary_.nodes.size() > 0;
      case Traversal::bvhWide:
        return wide_.nodes.size() > 0;
      case Traversal::embree:
        return false;
    }
    return false;
  }

  void setRays(std::span<const StreamRay> rays) override {
    rays_.allocate(backend_, "rays", rays.size());
    hits_.allocate(backend_, "rays", rays.size());
    backend_.upload(rays_, rays.data(), rays.size());
  }

  double trace(Traversal traversal, bool anyHit) override {
    if (!supports(traversal))
      throw Error(std::string("trace: there is no ") + name(traversal) + " here", ExitCode::usage);
    backend_.ledger().clearCounts();
    if (anyHit)
      launch<true>(traversal);
    else
      launch<false>(traversal);
    double seconds = 0;
    for (const auto& [stage, time] : backend_.ledger().seconds()) seconds += time;
    return seconds;
  }

  std::vector<StreamHit> hits() override {
    std::vector<StreamHit> hits(hits_.size());
    backend_.download(hits.data(), hits_, hits.size());
    return hits;
  }

  DeviceInfo device() const override { return backend_.device(); }

 private:
  template <class T>
  struct Copied : Buffer<T> {
    void copy(Backend& backend, const std::vector<T>& from) {
      this->allocate(backend, "structures", from.size());
      backend.upload(*this, from.data(), from.size());
    }
  };

  template <int W>
  struct CopiedBvh {
    Copied<BvhNode<W>> nodes;
    Copied<std::uint32_t> items;

    void copy(Backend& backend, const Bvh<W>& bvh) {
      nodes.copy(backend, bvh.nodes);
      items.copy(backend, bvh.items);
    }
    BvhView<W> view() const { return {nodes.view(), items.view()}; }
  };

  static const char* name(Traversal traversal) { return traversals[std::size_t(traversal)].name; }

  static SceneStructures prepared(const StreamScene& scene) {
    SceneStructures p;
    p.flat = scene.flat;
    p.tree = scene.tree;
    if (scene.tree) p.features |= feature::tree;
    return p;
  }

  template <bool anyHit>
  void launch(Traversal traversal) {
    std::uint32_t const n = std::uint32_t(rays_.size());
    TraceBase<F, anyHit> const base{{rays_.view(), hits_.span()}, device_.view};
    constexpr FeatureBits ropes = F & ~feature::shortStack, stack = F | feature::shortStack;
    switch (traversal) {
      case Traversal::brute:
        return backend_.forEach(n, TraceBrute<F, anyHit>{base});
      case Traversal::ropes:
        return backend_.forEach(n, TraceTree<ropes, anyHit>{{base.batch, base.scene}});
      case Traversal::ropesShared:
        return backend_.forEachShared(n, TraceShared<F, anyHit>{base, top_.view()});
      case Traversal::shortStack: {
        TraceTree<stack, anyHit> stage{{base.batch, base.scene}};
        stage.scene.shortStack = true;
        return backend_.forEach(n, stage);
      }
      case Traversal::bvh:
        return backend_.forEach(n, TraceBvh<F, anyHit, 2>{base, binary_.view()});
      case Traversal::bvhRefill:
        return backend_.forEachRefilled(n, TraceRefilled<F, anyHit>{base, binary_.view()});
      case Traversal::bvhWide:
        return backend_.forEach(n, TraceBvh<F, anyHit, 4>{base, wide_.view()});
      case Traversal::embree:
        return;
    }
  }

  Backend backend_;
  DeviceScene<Backend> device_;
  Copied<KdNode> top_;
  CopiedBvh<2> binary_;
  CopiedBvh<4> wide_;
  Copied<Triangle> items_;
  Buffer<StreamRay> rays_;
  Buffer<StreamHit> hits_;
};

/// Kernels without tests for kinds of primitive that the scene lacks.
inline std::unique_ptr<RayStream> makeStream(const StreamScene& scene, const BackendChoice& choice) {
  if (scene.flat->quads.empty() && scene.flat->spheres.empty())
    return std::make_unique<RayStreamOn<Backend, feature::triangles>>(scene, choice);
  return std::make_unique<RayStreamOn<Backend, feature::triangles | feature::quads | feature::spheres>>(scene, choice);
}

}  // namespace ropelight::RL_TARGET
