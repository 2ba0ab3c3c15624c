#pragma once
// Choosing one of many by weight in constant time (Walker 1977; the tables by Vose 1991, "A Linear Algorithm for
// Generating Random Numbers with a Given Distribution").

#include <vector>

#include "render/core/numeric.h"
#include "render/intersection/scene_view.h"

namespace ropelight::RL_TARGET {

/// The number that u in [0, 1) falls on; u is rescaled to [0, 1) within its part of the bin.
RL_HD inline std::uint32_t pickByAlias(Span<const AliasBin> bins, Real& u) {
  Real const scaled = u * Real(bins.size);
  std::uint32_t const bin = minOf(std::uint32_t(scaled), bins.size - 1);
  Real const inBin = scaled - Real(bin);
  AliasBin const b = bins[bin];
  bool const own = inBin < b.keep;
  Real const rescaled = own ? inBin / b.keep : (inBin - b.keep) / (1 - b.keep);
  u = minOf(maxOf(rescaled, Real(0)), 1 - machineEpsilon);
  return own ? bin : b.other;
}

/// Weights are finite, not negative, and not all zero. Exact up to rounding of `keep`.
inline std::vector<AliasBin> makeAliasTable(const std::vector<double>& weights) {
  double sum = 0;
  for (double w : weights) sum += w;
  std::size_t const n = weights.size();
  std::vector<AliasBin> bins(n);
  std::vector<double> share(n);
  std::vector<std::uint32_t> small, large;
  for (std::size_t i = 0; i < n; ++i) {
    share[i] = weights[i] / sum * double(n);
    (share[i] < 1 ? small : large).push_back(std::uint32_t(i));
  }
  while (!small.empty() && !large.empty()) {
    std::uint32_t const s = small.back(), l = large.back();
    small.pop_back();
    bins[s] = {Real(share[s]), l};
    share[l] -= 1 - share[s];
    if (share[l] >= 1) continue;
    large.pop_back();
    small.push_back(l);
  }
  for (std::uint32_t i : small) bins[i] = {1, i};  // what rounding has left over
  for (std::uint32_t i : large) bins[i] = {1, i};
  return bins;
}

}  // namespace ropelight::RL_TARGET
