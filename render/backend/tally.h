#pragma once
// What stages count. Sums of integers: the same whatever the order of the threads.

#include "render/core/hd.h"

namespace ropelight {

struct Tally {
  std::uint32_t rays = 0;              ///< closest hit
  std::uint32_t shadowRays = 0;        ///< any hit
  std::uint32_t nonFinite = 0;         ///< samples left out of the image
  std::uint32_t truncated = 0;         ///< paths cut at the hard depth limit
  std::uint32_t nonFinitePaths = 0;    ///< of nonFinite, those that a camera path has brought
  std::uint32_t nonFinitePhotons = 0;  ///< photon paths ended since their flux or their place was not finite
};

struct TallyTotals {
  unsigned long long rays = 0, shadowRays = 0, nonFinite = 0, truncated = 0, nonFinitePaths = 0, nonFinitePhotons = 0;

  void add(const Tally& t) {
    rays += t.rays;
    shadowRays += t.shadowRays;
    nonFinite += t.nonFinite;
    truncated += t.truncated;
    nonFinitePaths += t.nonFinitePaths;
    nonFinitePhotons += t.nonFinitePhotons;
  }
  void add(const TallyTotals& t) {
    rays += t.rays;
    shadowRays += t.shadowRays;
    nonFinite += t.nonFinite;
    truncated += t.truncated;
    nonFinitePaths += t.nonFinitePaths;
    nonFinitePhotons += t.nonFinitePhotons;
  }
};

}  // namespace ropelight
