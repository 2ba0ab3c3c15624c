#pragma once
// What the integrators share: the scene on its device, the film, the counting of iterations, the statistics.

#include <chrono>

#include "render/integrator/prepare.h"
#include "render/integrator/stages/commit.h"
#include "render/integrator/stages/frame.h"
#include "render/integrator/variants.h"
#include "render/scene/upload.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class IntegratorBase : public Integrator {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  void advance(int count) final {
    auto const start = std::chrono::steady_clock::now();
    std::uint64_t const target = state_.committed + std::uint64_t(count);
    while (state_.committed < target) {
      // The first iteration shows how much room the photons need; later ones are queued without looking.
      std::uint64_t const batch = state_.committed == 0 ? 1 : std::min<std::uint64_t>(target - state_.committed, 16);
      for (std::uint64_t i = 0; i < batch; ++i) {
        frame_.iteration = std::uint32_t(state_.committed + i);
        iterate(state_.committed + i);
      }
      backend_.download(&state_, stateBuffer_, 1);
      if (state_.halt) recover();
    }
    backend_.synchronize();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void reset() override {
    state_ = IterationState{};
    backend_.upload(stateBuffer_, &state_, 1);
    backend_.clear(sum_);
    backend_.clearTallies();
    backend_.ledger().clearCounts();
    seconds_ = 0;
    regrown_ = 0;
  }

  Image film() const override {
    std::vector<glm::dvec3> sums(frame_.slots());
    backend_.download(sums.data(), sum_, sums.size());
    Image image(frame_.width, frame_.height);
    double const scale = state_.committed > 0 ? 1.0 / double(state_.committed) : 0.0;
    for (std::uint32_t slot = 0; slot < sums.size(); ++slot) {
      int x, y;
      if (frame_.pixelOf(slot, x, y)) image.at(x, y) = Rgb(sums[slot] * scale);
    }
    return image;
  }

  Stats stats() const override {
    Stats s;
    TallyTotals const t = backend_.tallies();
    s.iterations = state_.committed;
    s.seconds = seconds_;
    s.rays = t.rays;
    s.shadowRays = t.shadowRays;
    s.nonFinite = t.nonFinite;
    s.truncatedPaths = t.truncated;
    s.photonsStored = state_.stored;
    s.regrown = regrown_;
    s.accel = prepared_.settings.accel;
    s.kernelRow = rowFor(prepared_.features).name;
    s.features = prepared_.features;
    s.device = backend_.device().name;
    s.settings = prepared_.settings;
    s.treeNodes = treeNodes_;
    s.treeLeaves = treeLeaves_;
    s.treeDepth = prepared_.tree.stats.depth;
    s.treeSeconds = prepared_.tree.stats.seconds;
    s.treeCost = prepared_.tree.stats.sahCost;
    s.bytes = backend_.ledger().bytes();
    s.launches = backend_.ledger().launches();
    s.stageSeconds = backend_.ledger().seconds();
    return s;
  }

 protected:
  explicit IntegratorBase(const Prepared& p) : prepared_(p), backend_(p.backend), scene_(backend_, p) {
    const Settings& s = prepared_.settings;
    frame_.scene = scene_.view;
    frame_.camera = makeCamera(p.camera, s.width, s.height);
    frame_.width = s.width;
    frame_.height = s.height;
    frame_.sampler = s.sampler == IndependentSampler::name ? Samplers::indexOf<IndependentSampler>()
                                                           : Samplers::indexOf<SobolSampler>();
    frame_.maxDepth = s.maxDepth;
    frame_.seed = s.seed;
    frame_.indirectOnly = s.indirectOnly;
    frame_.shadowRays = !(s.mode == "sppm" && s.direct == "photons");
    radiance_.allocate(backend_, "film", frame_.slots());
    sum_.allocate(backend_, "film", frame_.slots());
    stateBuffer_.allocate(backend_, "film", 1);
    treeNodes_ = p.tree.nodes.size();
    treeLeaves_ = p.tree.leaves.size();
    prepared_.tree = KdTree{};  // on the device now, but for its figures
    prepared_.tree.stats = p.tree.stats;
    prepared_.flat.triangles = {};
    IntegratorBase::reset();
  }

  /// Queues iteration i (from 0), ending with commit().
  virtual void iterate(std::uint64_t i) = 0;
  /// Makes room after a halt; the same iteration follows.
  virtual void recover() { throw Error("an iteration halted that stores nothing", ExitCode::internal); }

  void commit() {
    backend_.forEach(frame_.slots(), CommitFilm{radiance_.view(), sum_.span(), stateBuffer_.view()});
    backend_.forEach(1, EndIteration{stateBuffer_.span()});
  }

  void clearHalt() {
    state_.halt = 0;
    state_.photonsNeeded = state_.tailNeeded = 0;
    backend_.upload(stateBuffer_, &state_, 1);
    ++regrown_;
  }

  Prepared prepared_;
  mutable Backend backend_;
  DeviceScene<Backend> scene_;
  FrameView frame_;
  Buffer<Rgb> radiance_;
  Buffer<glm::dvec3> sum_;
  Buffer<IterationState> stateBuffer_;
  IterationState state_;  ///< as last seen on the device
  std::uint64_t treeNodes_ = 0, treeLeaves_ = 0;
  double seconds_ = 0;
  std::uint64_t regrown_ = 0;
};

}  // namespace ropelight::RL_TARGET
