#pragma once
// Density estimation at the gather points (Jensen 1996): flux over the disc's area, by radius or by k nearest.

#include "render/backend/tally.h"
#include "render/kernels/gather_nearest.h"

namespace ropelight::RL_TARGET {

/// What the gather adds to the film: radiance, or what there is to see of the gather itself.
enum class Gathered : std::uint8_t { radiance, photonCount, radius };

/// Adds an estimate to the film.
RL_HD inline void putGathering(Rgb& film, const GatherPoint& g, const Gathering& sum, Gathered output) {
  if (output == Gathered::radiance) {
    if (sum.radius2 > 0) film += g.weight * sum.flux * float(invPi / (sum.radius2 * sum.share));
  } else if (output == Gathered::photonCount) {
    film += Rgb(float(sum.count));
  } else {
    film = Rgb(float(sqrt(sum.radius2)));
  }
}

struct GatherRadius {
  static constexpr const char* name = "GatherRadius";
  static constexpr std::uint32_t grain = 512;

  GatherView view;
  Span<const GatherPoint> points;
  Span<Rgb> radiance;
  Gathered output = Gathered::radiance;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (!isBlack(g.weight)) putGathering(radiance[slot], g, gatherDisc(view, g), output);
  }
};

struct GatherNearest {
  static constexpr const char* name = "GatherNearest";
  static constexpr std::uint32_t grain = 256;

  GatherView view;
  int k = 50;
  Span<const GatherPoint> points;
  Span<Rgb> radiance;
  Gathered output = Gathered::radiance;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (!isBlack(g.weight)) putGathering(radiance[slot], g, gatherNearest(view, g, k), output);
  }
};

}  // namespace ropelight::RL_TARGET
