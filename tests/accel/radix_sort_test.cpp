// The radix sort against the standard library's.

#include "render/core/radix_sort.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "tests/support/test_random.h"

using namespace ropelight;

TEST_CASE("the radix sort is a stable sort by the low bits of the keys") {
  TestRandom random(1);
  for (std::uint32_t n : {1u, 2u, 63u, 1000u, 2049u, 60000u})
    for (int bits : {1, 5, 11, 12, 22, 23, 32})
      for (int threads : {1, 2, 7, 64}) {
        std::vector<std::uint32_t> keys(n), values(n), order(n), keyScratch(n), valueScratch(n);
        // Full words, some alike: bits above `bits` must not matter.
        for (std::uint32_t& k : keys) k = random.below(3) == 0 ? 0x80000000u | random.below(4) : random.word();
        for (std::uint32_t& v : values) v = random.word();
        std::iota(order.begin(), order.end(), 0u);
        std::uint32_t const mask = bits == 32 ? ~0u : (1u << bits) - 1;
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return (keys[a] & mask) < (keys[b] & mask); });
        std::vector<std::uint32_t> expectedKeys, expectedValues;
        for (std::uint32_t i : order) {
          expectedKeys.push_back(keys[i]);
          expectedValues.push_back(values[i]);
        }
        radixSortPairs(keys.data(), values.data(), keyScratch.data(), valueScratch.data(), n, bits, threads);
        if (keys != expectedKeys || values != expectedValues) FAIL("n ", n, " bits ", bits, " threads ", threads);
      }
}

TEST_CASE("nothing can be sorted") {
  radixSortPairs(nullptr, nullptr, nullptr, nullptr, 0, 32, 4);
  std::uint32_t key = 7, value = 9, scratch[2] = {0, 0};
  radixSortPairs(&key, &value, scratch, scratch + 1, 1, 0, 4);  // no bits: already in order
  CHECK((key == 7 && value == 9));
}
