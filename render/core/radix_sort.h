#pragma once
// A stable parallel radix sort of 32-bit key–value pairs for the CPU.

#include <cstdint>

namespace ropelight {

/// Sorts n pairs by the low `bits` of the keys; the result is in keys and values. The scratch arrays hold n elements
/// each. The result does not depend on `threads`.
void radixSortPairs(std::uint32_t* keys, std::uint32_t* values, std::uint32_t* keyScratch, std::uint32_t* valueScratch,
                    std::uint32_t n, int bits, int threads);

/// The same, but spares the last copy: true where the result was left in the scratch arrays.
bool radixSortPairsAside(std::uint32_t* keys, std::uint32_t* values, std::uint32_t* keyScratch,
                         std::uint32_t* valueScratch, std::uint32_t n, int bits, int threads);

}  // namespace ropelight
