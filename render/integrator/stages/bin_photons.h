#pragma once
// From slots to a sorted grid: keys, then (after the sort) the photons in order and the start of each cell.

#include "render/backend/tally.h"
#include "render/integrator/stages/photon_store.h"

namespace ropelight::RL_TARGET {

/// Writes the key and the slot of every photon of a path; a key past the last cell fills what is left of the list.
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
      store.keys[first + j] = grid.key(store.positions[slot].p);
      store.slots[first + j] = slot;
    }
  }
};

struct PadKeys {
  static constexpr const char* name = "PadKeys";
  static constexpr std::uint32_t grain = 65536;

  PhotonStore store;
  std::uint32_t cells;

  RL_HD void operator()(std::uint32_t k, Tally&) const {
    if (store.state[0].halt || k >= store.offsets[store.paths].all) {
      store.keys[k] = cells;
      store.slots[k] = 0;
    }
  }
};

struct OrderPhotons {
  static constexpr const char* name = "OrderPhotons";
  static constexpr std::uint32_t grain = 8192;

  PhotonStore store;
  std::uint32_t cells;
  Span<std::uint32_t> starts;
  Span<PhotonPosition> positions;
  Span<PhotonPower> powers;

  /// k in [0, photonCapacity]: the last one only closes the cells after the last photon.
  RL_HD void operator()(std::uint32_t k, Tally&) const {
    std::uint32_t const key = k < store.photonCapacity ? store.keys[k] : cells;
    std::uint32_t const next = k > 0 ? store.keys[k - 1] + 1 : 0;
    for (std::uint32_t c = next; c <= key; ++c) starts[c] = k;
    if (key >= cells) return;
    positions[k] = store.positions[store.slots[k]];
    powers[k] = store.powers[store.slots[k]];
  }
};

}  // namespace ropelight::RL_TARGET
