#pragma once
// The film takes an iteration only where nothing halted it, so that the host need not look before the next one starts.

#include "render/backend/tally.h"
#include "render/kernels/photon_store.h"

namespace ropelight::RL_TARGET {

/// Sums in double: a float sum would stall after some 10⁷ samples of like size.
struct CommitFilm {
  static constexpr const char* name = "CommitFilm";
  static constexpr std::uint32_t grain = 8192;

  Span<const Rgb> radiance;
  Span<glm::dvec3> sum;
  Span<const IterationState> state;

  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    if (state[0].halt) return;
    Rgb const sample = radiance[slot];
    if (isFinite(Vec3(sample)))
      sum[slot] += glm::dvec3(sample);
    else
      ++tally.nonFinite;
  }
};

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
