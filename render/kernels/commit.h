#pragma once
// The film takes an iteration only where nothing halted it, so that the host need not look before the next one starts.

#include "render/backend/tally.h"
#include "render/photons/photon_store.h"

namespace ropelight::RL_TARGET {

/// Sums in double: a float sum would stall after some 10⁷ samples of like size.
struct CommitFilm {
  static constexpr const char* name = "CommitFilm";
  static constexpr std::uint32_t grain = 8192;

  Span<const Rgb> radiance;
  Span<glm::dvec3> sum;
  Span<std::uint32_t> missing;  ///< samples that were left out, since they were not finite
  Span<const IterationState> state;

  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    if (state[0].halt) return;
    Rgb const sample = radiance[slot];
    if (isFinite(Vec3(sample))) {
      sum[slot] += glm::dvec3(sample);
    } else {
      ++missing[slot];
      ++tally.nonFinite;
    }
  }
};

/// The mean of a pixel's samples: one that is missing counts neither as light nor as darkness. Black where all are.
RL_HD inline Rgb meanOf(glm::dvec3 sum, std::uint64_t samples, std::uint32_t missing) {
  return samples > missing ? Rgb(sum * (1.0 / double(samples - missing))) : Rgb(0.0f);
}

struct EndIteration {
  static constexpr const char* name = "EndIteration";
  static constexpr std::uint32_t grain = 1;

  Span<IterationState> state;

  RL_HD void operator()(std::uint32_t, Tally&) const {
    IterationState& s = state[0];
    if (!s.halt) {
      ++s.committed;
      s.stored += s.pending;
    }
    s.pending = 0;
  }
};

}  // namespace ropelight::RL_TARGET
