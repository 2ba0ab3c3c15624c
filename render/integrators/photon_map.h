#pragma once
// The photons of one chunk: traced, stored, sorted into the grid.

#include <algorithm>

#include "render/integrators/base.h"
#include "render/integrators/photon_bins.h"
#include "render/kernels/trace_photons.h"

namespace ropelight::RL_TARGET {

/// How the photons of an iteration are divided and stored.
struct PhotonPlan {
  std::uint32_t paths = 0;  ///< of a chunk
  std::uint32_t chunks = 1;
  std::uint32_t stripe = 8;
  std::uint32_t photonCapacity = 0;
  std::uint32_t tailCapacity = 0;
  std::uint32_t tableSize = 0;  ///< cells of the grid, a power of two

  static constexpr std::uint64_t slotBytes = sizeof(Photon);

  /// Slots of stripes and tails; numbered in 32 bits.
  std::uint64_t slots() const { return std::uint64_t(paths) * stripe + tailCapacity; }

  std::uint64_t bytes() const {
    return (slots() + photonCapacity) * slotBytes + std::uint64_t(photonCapacity) * 4 * sizeof(std::uint32_t) +
           std::uint64_t(paths) * (2 * sizeof(DepositCount) + sizeof(std::uint32_t)) + std::uint64_t(tableSize) * 4;
  }
};

/// Deposits of a path, and those beyond the stripe, that the first plan has room for.
inline constexpr double expectedPerPath = 2.5, expectedTail = 0.1;

/// The largest plan for `photons` paths that stays within `budget` bytes: fewer slots a path first, then more chunks.
/// perPath: expected deposits of a path; tail: expected share of them beyond the stripe.
inline PhotonPlan planPhotons(std::uint64_t photons, std::uint64_t budget, double perPath, double tailPerPath) {
  PhotonPlan plan;
  for (std::uint64_t chunks = 1;; chunks *= 2) {
    std::uint64_t const paths = (photons + chunks - 1) / chunks;
    plan.paths = std::uint32_t(paths);
    plan.chunks = std::uint32_t((photons + paths - 1) / paths);
    auto const room = [&](double each) { return std::uint32_t(std::min(4.0e9, double(paths) * each * 1.15 + 1024)); };
    plan.photonCapacity = room(perPath);
    plan.tailCapacity = room(tailPerPath);
    plan.tableSize = tableFor(plan.photonCapacity);
    bool const numbered = plan.slots() < (1ull << 31) && plan.photonCapacity < (1u << 31);
    if ((plan.bytes() <= budget && numbered) || paths <= 1024) return plan;
  }
}

template <class Backend, FeatureBits F>
class PhotonMap {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  /// Throws std::bad_alloc where the memory cannot be had.
  void allocate(Backend& backend, const PhotonPlan& plan) {
    plan_ = plan;
    std::size_t const slots = std::size_t(plan.paths) * plan.stripe + plan.tailCapacity;
    slots_.allocate(backend, "photons", slots);
    counts_.allocate(backend, "photon paths", plan.paths);
    offsets_.allocate(backend, "photon paths", std::size_t(plan.paths) + 1);
    longPaths_.allocate(backend, "photon paths", plan.paths);
    bins_.allocate(backend, plan.photonCapacity, plan.tableSize);
  }

  void release() {
    slots_.release();
    for (auto* b : {&counts_, &offsets_}) b->release();
    longPaths_.release();
    bins_.release();
  }

  /// Traces paths [first, first + count) and leaves them in grid().
  void build(Backend& backend, const FrameView& frame, Buffer<IterationState>& state, std::uint64_t first,
             std::uint32_t count, Real pathsPerIteration, const FlatScene& scene, Real cellSize) {
    PhotonStore const store = storeFor(count, state);
    backend.forEach(count, TracePhotons<F>{frame, store, first, pathsPerIteration});
    backend.exclusiveScan(counts_, offsets_, count);
    backend.forEach(count, ListLongPaths{store});
    backend.forEach(1, CheckRoom{store});
    std::uint32_t const tails = std::min(count, plan_.tailCapacity);
    backend.forEach(tails, TraceTails<F>{frame, store, first, pathsPerIteration});
    bins_.layOut(scene.bounds, double(cellSize), plan_.tableSize);
    backend.forEach(count, WriteKeys{store, grid()});
    backend.forEach(plan_.photonCapacity, PadKeys{store, grid().cells});
    bins_.sort(backend, slots_.view(), state.view());
  }

  const PhotonGrid& grid() const { return bins_.grid(); }
  const PhotonPlan& plan() const { return plan_; }

 private:
  PhotonStore storeFor(std::uint32_t count, Buffer<IterationState>& state) {
    PhotonStore s;
    s.paths = count;
    s.stripe = plan_.stripe;
    s.tailCapacity = plan_.tailCapacity;
    s.photonCapacity = plan_.photonCapacity;
    s.photons = slots_.span();
    s.counts = counts_.span();
    s.offsets = offsets_.span();
    s.longPaths = longPaths_.span();
    s.keys = bins_.keys();
    s.slots = bins_.slots();
    s.state = state.span();
    return s;
  }

  PhotonPlan plan_;
  PhotonBins<Backend> bins_;
  Buffer<Photon> slots_;
  Buffer<DepositCount> counts_, offsets_;
  Buffer<std::uint32_t> longPaths_;
};

}  // namespace ropelight::RL_TARGET
