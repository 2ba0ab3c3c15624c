#include "render/core/radix_sort.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace ropelight {
namespace {

constexpr int digitBits = 11;
constexpr std::uint32_t buckets = 1u << digitBits;
using Histogram = std::array<std::uint32_t, buckets>;

/// One counting pass: blocks are contiguous, so that offsets by (digit, block) keep the order of equal keys.
void pass(const std::uint32_t* keys, const std::uint32_t* values, std::uint32_t* keysOut, std::uint32_t* valuesOut,
          std::uint32_t n, int shift, int width, std::vector<Histogram>& histograms) {
  std::uint32_t const blocks = std::uint32_t(histograms.size());
  std::uint64_t const step = (std::uint64_t(n) + blocks - 1) / blocks;
  auto first = [&](std::uint32_t b) { return std::uint32_t(std::min<std::uint64_t>(n, b * step)); };
  auto digit = [&](std::uint32_t key) { return (key >> shift) & ((1u << width) - 1); };
  oneapi::tbb::parallel_for(0u, blocks, [&](std::uint32_t b) {
    histograms[b].fill(0);
    for (std::uint32_t i = first(b); i < first(b + 1); ++i) ++histograms[b][digit(keys[i])];
  });
  std::uint32_t sum = 0;
  for (std::uint32_t d = 0; d < buckets; ++d)
    for (Histogram& h : histograms) {
      std::uint32_t const count = h[d];
      h[d] = sum;
      sum += count;
    }
  oneapi::tbb::parallel_for(0u, blocks, [&](std::uint32_t b) {
    for (std::uint32_t i = first(b); i < first(b + 1); ++i) {
      std::uint32_t const to = histograms[b][digit(keys[i])]++;
      keysOut[to] = keys[i];
      valuesOut[to] = values[i];
    }
  });
}

}  // namespace

bool radixSortPairsAside(std::uint32_t* keys, std::uint32_t* values, std::uint32_t* keyScratch,
                         std::uint32_t* valueScratch, std::uint32_t n, int bits, int threads) {
  if (n == 0) return false;
  std::vector<Histogram> histograms(std::size_t(std::clamp(threads, 1, 64)));
  int const passes = (bits + digitBits - 1) / digitBits;
  for (int done = 0, shift = 0; done < passes; ++done) {
    int const width = (bits - shift + passes - done - 1) / (passes - done);  // digits of equal width
    pass(keys, values, keyScratch, valueScratch, n, shift, width, histograms);
    shift += width;
    std::swap(keys, keyScratch);
    std::swap(values, valueScratch);
  }
  return passes % 2 == 1;
}

void radixSortPairs(std::uint32_t* keys, std::uint32_t* values, std::uint32_t* keyScratch, std::uint32_t* valueScratch,
                    std::uint32_t n, int bits, int threads) {
  if (!radixSortPairsAside(keys, values, keyScratch, valueScratch, n, bits, threads)) return;
  std::memcpy(keys, keyScratch, std::size_t(n) * sizeof(std::uint32_t));
  std::memcpy(values, valueScratch, std::size_t(n) * sizeof(std::uint32_t));
}

}  // namespace ropelight
