#pragma once
// Splits between bins of equal width (Wald 2007): nearly as good as the sweep's, from one pass over a node's
// primitives.

#include <span>

#include "accel/bvh/sweep.h"

namespace ropelight::bvh {

/// Divides the list, keeping its order on both sides, by the best split between `bins` bins per axis that costs less
/// than `limit`. `at` counts from the front of the list; axis −1: there is none, and the list is as it was.
Split divideByBins(const Primitives& primitives, std::span<std::uint32_t> list, int bins, float limit, Box halves[2]);

}  // namespace ropelight::bvh
