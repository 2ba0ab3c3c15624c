#pragma once
// How the photons of an iteration are divided into chunks, and how much room they get.

#include <algorithm>
#include <bit>

#include "render/photons/photon_store.h"

namespace ropelight::RL_TARGET {

/// Cells of the table for that many photons: about twice as many, a power of two.
inline std::uint32_t tableFor(std::uint64_t photons) {
  return std::uint32_t(std::bit_ceil(std::clamp<std::uint64_t>(2 * photons, 1u << 16, 1u << 26)));
}

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

/// The largest plan for `photons` paths that stays within `budget` bytes, in as many chunks as it takes; one of 1024
/// paths is not divided further. perPath: expected deposits of a path; tail: expected share of them beyond the stripe.
inline PhotonPlan planPhotons(std::uint64_t photons, std::uint64_t budget, double perPath, double tailPerPath,
                              std::uint32_t stripe = 8) {
  PhotonPlan plan;
  plan.stripe = stripe;
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

/// The same for photons of caustics, of which a path leaves one or none.
inline PhotonPlan planCaustics(std::uint64_t photons, std::uint64_t budget) {
  return planPhotons(photons, budget, 1, 0, 1);
}

/// What of the budget for photons is for caustics, where they are apart.
inline std::uint64_t causticBudget(std::uint64_t budget) { return budget / 4; }

}  // namespace ropelight::RL_TARGET
