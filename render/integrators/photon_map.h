#pragma once
// The photons of one chunk: traced, stored, sorted into the grid.

#include <algorithm>

#include "render/integrators/base.h"
#include "render/integrators/photon_bins.h"
#include "render/kernels/trace_photons.h"
#include "render/launch/launch.h"
#include "render/photons/photon_plan.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class PhotonMap {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  /// Throws std::bad_alloc where the memory cannot be had.
  /// directions: whether photons keep theirs.
  void allocate(Backend& backend, const PhotonPlan& plan, bool directions) {
    plan_ = plan;
    std::size_t const slots = std::size_t(plan.paths) * plan.stripe + plan.tailCapacity;
    slots_.allocate(backend, "photons", slots);
    directions_.allocate(backend, "photons", directions ? slots : 0);
    counts_.allocate(backend, "photon paths", plan.paths);
    offsets_.allocate(backend, "photon paths", std::size_t(plan.paths) + 1);
    longPaths_.allocate(backend, "photon paths", plan.paths);
    bins_.allocate(backend, plan.photonCapacity, plan.tableSize, directions);
  }

  void release() {
    slots_.release();
    directions_.release();
    for (auto* b : {&counts_, &offsets_}) b->release();
    longPaths_.release();
    bins_.release();
  }

  /// Traces paths [first, first + count) in a kernel row and leaves their photons in grid().
  void build(Backend& backend, int row, const FrameView& frame, Buffer<IterationState>& state, std::uint64_t first,
             std::uint32_t count, Real pathsPerIteration, const FlatScene& scene, Real cellSize) {
    PhotonStore store = storeFor(count, state);
    store.caustics = frame.photonClass == PhotonClass::caustic;
    launch(backend, row, count, TracePhotonsArgs{frame, store, first, pathsPerIteration});
    backend.exclusiveScan(counts_, offsets_, count);
    backend.forEach(count, ListLongPaths{store});
    backend.forEach(1, CheckRoom{store});
    std::uint32_t const tails = std::min(count, plan_.tailCapacity);
    launch(backend, row, tails, TraceTailsArgs{frame, store, first, pathsPerIteration});
    bins_.layOut(scene.bounds, double(cellSize), plan_.tableSize);
    backend.forEach(count, WriteKeys{store, grid()});
    backend.forEach(plan_.photonCapacity, PadKeys{store, grid().cells});
    bins_.sort(backend, slots_.view(), state.view(), directions_.view());
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
    s.directions = directions_.span();
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
  Buffer<std::uint32_t> directions_;
  Buffer<DepositCount> counts_, offsets_;
  Buffer<std::uint32_t> longPaths_;
};

}  // namespace ropelight::RL_TARGET
