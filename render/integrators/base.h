#pragma once
// What the integrators share: the scene on its device, the film, the counting of iterations, the statistics.

#include <chrono>

#include "render/integrators/integrator.h"
#include "render/kernels/commit.h"
#include "render/kernels/frame_view.h"
#include "render/kernels/resolve.h"
#include "render/launch/launch.h"
#include "render/prepare/advice.h"
#include "render/prepare/prepare.h"
#include "render/upload/upload.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class IntegratorBase : public Integrator {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  bool advance(int count) final {
    backend_.activate();
    auto const start = std::chrono::steady_clock::now();
    std::uint64_t const target = state_.committed + std::uint64_t(count);
    while (state_.committed < target) {
      // The first iteration shows how much room the photons need; later ones are queued without looking.
      std::uint64_t const batch = state_.committed == 0 ? 1 : std::min<std::uint64_t>(target - state_.committed, 16);
      for (std::uint64_t i = 0; i < batch; ++i) {
        frame_.iteration = std::uint32_t(state_.committed + i);
        frame_.cameraSeed = cameraSeedOf(frame_.seed, state_.committed + i);
        iterate(state_.committed + i);
      }
      backend_.synchronize();
      if (backend_.interrupted()) return false;
      backend_.download(&state_, stateBuffer_, 1);
      if (state_.halt) recover();
    }
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return true;
  }

  void interrupt() final { backend_.interrupt(); }

  void reset() override {
    backend_.activate();
    backend_.resume();
    state_ = IterationState{};
    backend_.upload(stateBuffer_, &state_, 1);
    backend_.clear(sum_);
    backend_.clear(missing_);
    backend_.clearTallies();
    backend_.ledger().clearCounts();
    seconds_ = 0;
    regrown_ = 0;
  }

  bool restart(const CameraDesc& camera, const Settings& settings) final {
    std::optional<Prepared> next = prepareAgain(prepared_, camera, settings);
    if (!next) return false;
    backend_.activate();
    prepared_ = std::move(*next);
    configure();
    settingsChanged();
    reset();
    return true;
  }

  void timeStages(bool on) final { backend_.timeStages(on); }
  std::shared_ptr<const KdTree> tree() const final { return prepared_.tree; }
  Vec3d frameOrigin() const final { return prepared_.flat->origin; }
  int gpu() const final { return backend_.gpu(); }

  bool present() final {
    backend_.activate();
    std::size_t const pixels = std::size_t(frame_.width) * std::size_t(frame_.height);
    display_.allocate(backend_, "display", pixels);
    backend_.forEach(frame_.slots(),
                     ResolveFilm{frame_, state_.committed, sum_.view(), missing_.view(), display_.span()});
    backend_.synchronize();
    return !backend_.interrupted();
  }
  void copyPixels(void* to) const final { backend_.copyOut(to, display_, display_.size()); }

  std::uint32_t presentPhotons(std::uint32_t) override { return 0; }
  void copyPhotons(PhotonPoint*, std::uint32_t) const override {}

  Image film() const override {
    backend_.activate();
    Image image(frame_.width, frame_.height);
    std::vector<glm::dvec3> sums(std::min(frame_.slots(), filmBlock));  // a part at a time: a film may be large
    std::vector<std::uint32_t> missing(sums.size());
    for (std::uint32_t first = 0; first < frame_.slots(); first += std::uint32_t(sums.size())) {
      std::uint32_t const count = std::min(frame_.slots() - first, std::uint32_t(sums.size()));
      backend_.download(sums.data(), sum_, count, first);
      backend_.download(missing.data(), missing_, count, first);
      for (std::uint32_t i = 0; i < count; ++i) {
        int x, y;
        if (frame_.pixelOf(first + i, x, y)) image.at(x, y) = meanOf(sums[i], state_.committed, missing[i]);
      }
    }
    return image;
  }

  Stats stats() const override {
    backend_.activate();
    Stats s;
    TallyTotals const t = backend_.tallies();
    s.iterations = state_.committed;
    s.seconds = seconds_;
    s.rays = t.rays;
    s.shadowRays = t.shadowRays;
    s.nonFinite = t.nonFinite + t.nonFinitePhotons;
    const char* const paths = prepared_.settings.mode == Mode::path ? "TracePath" : "TraceCamera";
    for (auto const& [stage, count] : {std::pair{paths, t.nonFinitePaths},
                                       {"TracePhotons", t.nonFinitePhotons},
                                       {"gather", t.nonFinite - t.nonFinitePaths}})
      if (count > 0) s.nonFiniteBy[stage] = count;
    s.truncatedPaths = t.truncated;
    s.photonsStored = state_.stored;
    s.regrown = regrown_;
    s.accel = nameOf(prepared_.settings.accel);
    s.kernelRow = kernelRows[row_].name;
    s.features = prepared_.features;
    s.device = backend_.device().name;
    s.settings = prepared_.settings;
    s.advice = advice_;
    if (const Bvh<2>* bvh = prepared_.bvh.get()) {
      s.treeNodes = bvh->nodes.size();
      s.treeLeaves = bvh->stats.leaves;
      s.treeDepth = bvh->stats.depth;
      s.treeSeconds = bvh->stats.seconds;
      s.treeCost = bvh->stats.sahCost;
    }
    if (prepared_.bvh && prepared_.meshBvhs)
      for (const Bvh<2>& bvh : *prepared_.meshBvhs) {
        s.treeNodes += bvh.nodes.size();
        s.treeLeaves += bvh.stats.leaves;
        s.treeSeconds += bvh.stats.seconds;
      }
    if (const KdTree* tree = prepared_.tree.get()) {
      s.treeNodes = tree->nodes.size();
      s.treeLeaves = tree->leaves.size();
      s.treeDepth = tree->stats.depth;
      s.treeSeconds = tree->stats.seconds;
      s.treeCost = tree->stats.sahCost;
    }
    s.bytes = backend_.ledger().bytes();
    s.launches = backend_.ledger().launches();
    s.stageSeconds = backend_.ledger().seconds();
    return s;
  }

 protected:
  explicit IntegratorBase(const Prepared& p) : prepared_(p), backend_(p.backend), scene_(backend_, p) {
    frame_.scene = scene_.view;
    stateBuffer_.allocate(backend_, "film", 1);
    configure();
    IntegratorBase::reset();
  }

  /// After restart() has taken other settings, and before the film is emptied.
  virtual void settingsChanged() {}

  /// Queues iteration i (from 0), ending with commit().
  virtual void iterate(std::uint64_t i) = 0;
  /// Makes room after a halt; the same iteration follows.
  virtual void recover() { throw Error("an iteration halted that stores nothing", ExitCode::internal); }

  void commit() {
    backend_.forEach(frame_.slots(), CommitFilm{radiance_.view(), sum_.span(), missing_.span(), stateBuffer_.view()});
    backend_.forEach(1, EndIteration{stateBuffer_.span()});
  }

  /// Runs a stage of which every kernel row has its own.
  template <class Args>
  void run(std::uint32_t n, const Args& args) {
    launch(backend_, row_, n, args);
  }

  /// What the camera and the settings decide.
  void configure() {
    const Settings& s = prepared_.settings;
    advice_ = adviceOn(prepared_);
    row_ = rowFor(prepared_.features);
    frame_.camera = makeCamera(prepared_.camera, s.width, s.height);
    frame_.width = s.width;
    frame_.height = s.height;
    frame_.sampler = s.sampler == SamplerKind::independent ? Samplers::indexOf<IndependentSampler>()
                                                           : Samplers::indexOf<SobolSampler>();
    frame_.maxDepth = s.maxDepth;
    frame_.seed = s.seed;
    frame_.indirectOnly = s.indirectOnly;
    frame_.shadowRays = !(s.mode == Mode::sppm && s.direct == DirectLight::photons);
    frame_.dark = s.aov != Aov::radiance;
    radiance_.allocate(backend_, "film", frame_.slots());
    sum_.allocate(backend_, "film", frame_.slots());
    missing_.allocate(backend_, "film", frame_.slots());
  }

  void clearHalt() {
    state_.halt = 0;
    state_.photonsNeeded = state_.tailNeeded = 0;
    backend_.upload(stateBuffer_, &state_, 1);
    ++regrown_;
  }

  static constexpr std::uint32_t filmBlock = 1u << 20;  ///< slots that are copied at once

  Prepared prepared_;
  mutable Backend backend_;
  DeviceScene<Backend> scene_;
  FrameView frame_;
  Buffer<Rgb> radiance_;
  Buffer<glm::dvec3> sum_;
  Buffer<std::uint32_t> missing_;
  Buffer<IterationState> stateBuffer_;
  IterationState state_;  ///< as last seen on the device
  Buffer<DisplayPixel> display_;
  double seconds_ = 0;
  std::uint64_t regrown_ = 0;
  std::vector<std::string> advice_;
  int row_ = 0;  ///< of kernelRows
};

}  // namespace ropelight::RL_TARGET
