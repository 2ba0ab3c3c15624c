#pragma once
// Where photons lie between tracing and gathering. The first `stripe` deposits of a path go to fixed slots while the
// path is traced; the rest of the few long paths are written by tracing those again, at places known from a scan. So
// nothing is dropped or overwritten, and the order depends on path numbers alone.

#include "accel/photon_grid/photon.h"
#include "render/core/features.h"
#include "render/core/span.h"

namespace ropelight::RL_TARGET {

/// Deposits of one path, or their sums over all paths before it.
struct DepositCount {
  std::uint32_t all = 0;     ///< deposits
  std::uint32_t tail = 0;    ///< those beyond the stripe
  std::uint32_t longer = 0;  ///< 1 where there is a tail

  /// Saturating: a sum past 2³² − 1 must not look as if it fitted.
  RL_HD DepositCount operator+(const DepositCount& o) const {
    return DepositCount{sum(all, o.all), sum(tail, o.tail), longer + o.longer};
  }

  RL_HD static std::uint32_t sum(std::uint32_t a, std::uint32_t b) { return a + b < a ? 0xFFFFFFFFu : a + b; }
};

/// Shared by the stages of an iteration. Sticky: once `halt` is set nothing is committed until the host has made room.
struct IterationState {
  std::uint32_t halt = 0;
  std::uint32_t photonsNeeded = 0;  ///< of the chunk that did not fit
  std::uint32_t tailNeeded = 0;
  std::uint32_t chunkPhotons = 0;  ///< of the chunk being traced
  std::uint32_t otherPhotons = 0;  ///< of the latest chunk that is not of caustics
  unsigned long long pending = 0;  ///< photons of the iteration so far
  unsigned long long committed = 0;
  unsigned long long stored = 0;

  /// To be sorted: none where the iteration has halted.
  RL_HD std::uint32_t photons() const { return halt ? 0 : chunkPhotons; }
};

struct PhotonStore {
  std::uint32_t paths = 0;   ///< of this chunk
  std::uint32_t stripe = 0;  ///< slots of each path
  std::uint32_t tailCapacity = 0;
  std::uint32_t photonCapacity = 0;
  bool caustics = false;           ///< a map of caustics alone
  Span<Photon> photons;            ///< paths·stripe + tailCapacity: slot j·paths + path, then tails
  Span<std::uint32_t> directions;  ///< by slot, packed: to where each came from; empty but with feature::glossy
  Span<DepositCount> counts;       ///< by path
  Span<DepositCount> offsets;      ///< by path, and the totals after the last
  Span<std::uint32_t> longPaths;
  Span<std::uint32_t> keys;   ///< photonCapacity
  Span<std::uint32_t> slots;  ///< photonCapacity
  Span<IterationState> state;

  template <FeatureBits F>
  RL_HD void put(std::uint32_t slot, const Photon& photon, Vec3 w) const {
    photons[slot] = photon;
    if constexpr ((F & feature::glossy) != 0)
      if (!directions.empty()) directions[slot] = packDirection(w);
  }

  RL_HD std::uint32_t slotOf(std::uint32_t path, std::uint32_t deposit) const {
    if (deposit < stripe) return deposit * paths + path;
    return stripe * paths + offsets[path].tail + (deposit - stripe);
  }
};

}  // namespace ropelight::RL_TARGET
