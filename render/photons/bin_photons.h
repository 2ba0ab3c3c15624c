#pragma once
// From slots to a sorted grid: keys, then (after the sort) the photons in order and the start of each cell.

#include "accel/photon_grid/photon_grid.h"
#include "render/backend/tally.h"
#include "render/photons/photon_store.h"

namespace ropelight::RL_TARGET {

/// Writes the key and the slot of every photon of a path.
struct WriteKeys {
  static constexpr const char* name = "WriteKeys";
  static constexpr std::uint32_t grain = 4096;

  PhotonStore store;
  PhotonGrid grid;

  RL_HD void operator()(std::uint32_t path, Tally&) const {
    if (store.state[0].halt) return;
    std::uint32_t const first = store.offsets[path].all, count = store.counts[path].all;
    for (std::uint32_t j = 0; j < count; ++j) {
      std::uint32_t const slot = store.slotOf(path, j);
      store.keys[first + j] = grid.key(store.photons[slot].position.p);
      store.slots[first + j] = slot;
    }
  }
};

/// Fills what is left of the list with the last cell's key: the sort is stable, so these stay behind all photons.
struct PadKeys {
  static constexpr const char* name = "PadKeys";
  static constexpr std::uint32_t grain = 65536;

  PhotonStore store;
  std::uint32_t cells;

  RL_HD void operator()(std::uint32_t k, Tally&) const {
    if (k < store.state[0].photons()) return;
    store.keys[k] = cells - 1;
    store.slots[k] = 0;
  }
};

/// Fetches photon k of the sorted list and takes it apart.
struct OrderPhotons {
  static constexpr const char* name = "OrderPhotons";
  static constexpr std::uint32_t grain = 8192;

  Span<const Photon> photons;
  Span<const std::uint32_t> slots;  ///< sorted
  Span<const IterationState> state;
  Span<PhotonPosition> positions;
  Span<PhotonPower> powers;
  Span<const std::uint32_t> directions = {};  ///< by slot; empty where no surface asks
  Span<std::uint32_t> sortedDirections = {};

  RL_HD void operator()(std::uint32_t k, Tally&) const {
    if (k >= state[0].photons()) return;
    Photon const photon = photons[slots[k]];
    positions[k] = photon.position;
    powers[k] = photon.power;
    if (!directions.empty()) sortedDirections[k] = directions[slots[k]];
  }
};

/// Finds the first photon of each of `batch` cells in the sorted keys by bisection: a search a cell costs less than
/// letting a photon close the gap before it, which may be as long as the table.
struct FindCells {
  static constexpr const char* name = "FindCells";
  static constexpr std::uint32_t grain = 4;

  Span<const std::uint32_t> keys;  ///< sorted
  Span<const IterationState> state;
  Span<std::uint32_t> starts;
  std::uint32_t cells, batch;

  static std::uint32_t calls(std::uint32_t cells, std::uint32_t batch) { return cells / batch + 1; }

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    std::uint32_t const photons = state[0].photons(), first = i * batch;
    std::uint32_t const last = cells - first < batch ? cells : first + batch - 1;  // the entry after the last cell too
    std::uint32_t k = firstNotBelow(first, 0, photons);
    for (std::uint32_t cell = first; cell <= last; ++cell) starts[cell] = k = seek(cell, k, photons);
  }

 private:
  /// The first k in [low, high) whose key is not below the cell, or high.
  RL_HD std::uint32_t firstNotBelow(std::uint32_t cell, std::uint32_t low, std::uint32_t high) const {
    while (low < high) {
      std::uint32_t const middle = low + (high - low) / 2;
      if (keys[middle] >= cell)
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  }

  /// The same in steps that double, for an answer that is near.
  RL_HD std::uint32_t seek(std::uint32_t cell, std::uint32_t low, std::uint32_t high) const {
    for (std::uint32_t step = 1; high - low >= step; step *= 2) {
      if (keys[low + step - 1] >= cell) return firstNotBelow(cell, low, low + step - 1);
      low += step;
    }
    return firstNotBelow(cell, low, high);
  }
};

}  // namespace ropelight::RL_TARGET
