#pragma once
// Choosing one of many by weight in constant time, in the order of the random number (Chen & Asau 1974, "On Generating
// Random Variates from an Empirical Distribution"): stratified numbers stay stratified over what they choose, which an
// alias table would break up.

#include <vector>

#include "render/core/numeric.h"
#include "render/core/span.h"

namespace ropelight::RL_TARGET {

/// The number whose share of [0, 1) holds u. cdf: inclusive sums of the shares, the last one 1. guide: of each of as
/// many bins of equal width, the first number whose share reaches into it.
RL_HD inline std::uint32_t findByGuide(Span<const Real> cdf, Span<const std::uint32_t> guide, Real u) {
  std::uint32_t k = guide[minOf(std::uint32_t(u * Real(guide.size)), guide.size - 1)];
  while (k > 0 && u < cdf[k - 1]) --k;  // u·size may have been rounded into the next bin
  while (k + 1 < cdf.size && !(u < cdf[k])) ++k;
  return k;
}

inline std::vector<std::uint32_t> makeGuideTable(const std::vector<Real>& cdf) {
  std::vector<std::uint32_t> guide(cdf.size());
  std::uint32_t k = 0;
  for (std::size_t bin = 0; bin < guide.size(); ++bin) {
    while (k + 1 < cdf.size() && double(cdf[k]) * double(guide.size()) <= double(bin)) ++k;
    guide[bin] = k;
  }
  return guide;
}

}  // namespace ropelight::RL_TARGET
