#include "measure/streams/embree_stream.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>

#include "measure/streams/bvh_embree.h"

namespace ropelight {
namespace {

class EmbreeStream final : public RayStream {
 public:
  EmbreeStream(const StreamScene& scene, int threads, std::unique_ptr<RayStream> own)
      : flat_(scene.flat),
        threads_(threads),
        arena_(threads > 0 ? threads : oneapi::tbb::task_arena::automatic),
        own_(std::move(own)) {}

  bool supports(Traversal traversal) const override {
    return traversal == Traversal::embree || own_->supports(traversal);
  }

  void setRays(std::span<const StreamRay> rays) override {
    rays_.assign(rays.begin(), rays.end());
    own_->setRays(rays);
  }

  double trace(Traversal traversal, bool anyHit) override {
    last_ = traversal;
    if (traversal != Traversal::embree) return own_->trace(traversal, anyHit);
    if (!embree_) embree_ = std::make_unique<EmbreeScene>(*flat_, true, threads_);
    hits_.resize(rays_.size());
    auto const start = std::chrono::steady_clock::now();
    arena_.execute([&] {
      using Range = oneapi::tbb::blocked_range<std::size_t>;
      oneapi::tbb::parallel_for(Range(0, rays_.size(), 256), [&](const Range& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) hits_[i] = traceOne(rays_[i], anyHit);
      });
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::vector<StreamHit> hits() override { return last_ == Traversal::embree ? hits_ : own_->hits(); }
  DeviceInfo device() const override { return own_->device(); }

 private:
  StreamHit traceOne(const StreamRay& r, bool anyHit) const {
    EmbreeRay const ray{
        {r.origin[0], r.origin[1], r.origin[2]}, {r.direction[0], r.direction[1], r.direction[2]}, r.tMax};
    if (anyHit) return {0, embree_->occluded(ray) ? 0u : 0xFFFFFFFFu};
    EmbreeHit const hit = embree_->closest(ray);
    return {hit.t, hit.primitive};
  }

  std::shared_ptr<const FlatScene> flat_;
  int threads_;
  oneapi::tbb::task_arena arena_;
  std::unique_ptr<RayStream> own_;
  std::unique_ptr<EmbreeScene> embree_;
  std::vector<StreamRay> rays_;
  std::vector<StreamHit> hits_;
  Traversal last_ = Traversal::brute;
};

}  // namespace

std::unique_ptr<RayStream> withEmbree(const StreamScene& scene, int threads, std::unique_ptr<RayStream> own) {
  bool const trianglesAlone =
      scene.flat->quads.empty() && scene.flat->spheres.empty() && !scene.flat->triangles.empty();
  if (!EmbreeScene::supported() || !trianglesAlone) return own;
  return std::make_unique<EmbreeStream>(scene, threads, std::move(own));
}

}  // namespace ropelight
