#pragma once
// Whether two ways of computing the same thing agree: what a benchmark asks before it reports a time.

#include <cstdint>
#include <span>
#include <vector>

#include "measure/streams/gather_stream.h"
#include "measure/streams/ray_stream.h"

namespace ropelight {

/// The same found flag; of closest hits also the same primitive, or distances within 4 ulp of each other.
bool sameHit(const StreamHit& a, const StreamHit& b, bool anyHit);

/// How many of `hits` differ from those of the same rays in `expected`; all where the numbers of hits differ.
std::size_t differentHits(std::span<const StreamHit> hits, std::span<const StreamHit> expected, bool anyHit);

/// Every (count/n)-th of the numbers below `count`: at most n of them, at least one where count > 0.
std::vector<std::uint32_t> spreadNumbers(std::size_t count, std::size_t n);

template <class T>
std::vector<T> pick(std::span<const T> values, std::span<const std::uint32_t> numbers) {
  std::vector<T> picked;
  picked.reserve(numbers.size());
  for (std::uint32_t const i : numbers) picked.push_back(values[i]);
  return picked;
}

/// Gathers within a radius: how many differ in their count, or by more than 10⁻⁴ in their flux.
std::size_t differentGathers(std::span<const StreamGather> gathers, std::span<const StreamGather> expected);

/// Whether a gather of the k nearest is right, by a sort of every photon's distance in double: all photons within the
/// radius where there are fewer than k, else k of them and the distance of the farthest.
bool rightNearest(const StreamGather& gather, const StreamQuery& query, std::span<const StreamPhoton> photons,
                  float radius, int k);

}  // namespace ropelight
