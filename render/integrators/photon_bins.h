#pragma once
// Sorts photons into a grid: the part of a build that needs no path, so that it can be timed by itself.

#include <algorithm>
#include <bit>

#include "accel/photon_grid/grid_layout.h"
#include "render/photons/bin_photons.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class PhotonBins {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  /// Room for photons and, of the table, for most cells. Throws std::bad_alloc where the memory cannot be had.
  /// directions: whether photons keep theirs.
  void allocate(Backend& backend, std::uint32_t photons, std::uint32_t table, bool directions = false) {
    directions_.allocate(backend, "photons", directions ? photons : 0);
    positions_.allocate(backend, "photons", photons);
    powers_.allocate(backend, "photons", photons);
    for (auto* b : {&keys_, &slots_, &keyScratch_, &slotScratch_}) b->allocate(backend, "grid", photons);
    starts_.allocate(backend, "grid", std::size_t(table) + 1);
  }

  void release() {
    positions_.release();
    directions_.release();
    powers_.release();
    for (auto* b : {&keys_, &slots_, &keyScratch_, &slotScratch_, &starts_}) b->release();
  }

  /// Decides the cells; their photons follow with sort().
  void layOut(const Bounds& bounds, double cell, std::uint32_t table) {
    ropelight::RL_TARGET::layOut(grid_, bounds, cell, table);
    grid_.starts = starts_.view();
    grid_.positions = positions_.view();
    grid_.powers = powers_.view();
    grid_.directions = directions_.view();
  }

  /// To be filled by cell and slot before sort(), for as many photons as there is room.
  Span<std::uint32_t> keys() { return keys_.span(); }
  Span<std::uint32_t> slots() { return slots_.span(); }

  /// Photons of equal cells stay in the order of the list, whatever the threads.
  /// directions: by slot; empty where photons keep none.
  void sort(Backend& backend, Span<const Photon> photons, Span<const IterationState> state,
            Span<const std::uint32_t> directions = {}) {
    std::uint32_t const n = std::uint32_t(positions_.size());
    backend.sortPairs(keys_, slots_, keyScratch_, slotScratch_, n, std::max(1, int(std::bit_width(grid_.cells - 1))));
    backend.forEach(n, OrderPhotons{photons, slots_.view(), state, positions_.span(), powers_.span(), directions,
                                    directions_.span()});
    backend.forEach(FindCells::calls(grid_.cells, Backend::batch),
                    FindCells{keys_.view(), state, starts_.span(), grid_.cells, Backend::batch});
  }

  const PhotonGrid& grid() const { return grid_; }

 private:
  PhotonGrid grid_;
  Buffer<PhotonPosition> positions_;
  Buffer<PhotonPower> powers_;
  Buffer<std::uint32_t> directions_;
  Buffer<std::uint32_t> keys_, slots_, keyScratch_, slotScratch_, starts_;
};

}  // namespace ropelight::RL_TARGET
