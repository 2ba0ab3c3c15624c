#include "accel/bvh/bins.h"

#include <oneapi/tbb/parallel_reduce.h>

#include <array>

namespace ropelight::bvh {
namespace {

constexpr std::size_t mostBins = 64;
using Range = oneapi::tbb::blocked_range<std::size_t>;

/// Where centroids (twice, as Box has them) fall.
struct Grid {
  float low[3], scale[3];
  int bins;

  Grid(const Box& centers, int count) : bins(count) {
    for (int a = 0; a < 3; ++a) {
      float const width = centers.max[a] - centers.min[a];
      low[a] = centers.min[a];
      scale[a] = width > 0 ? float(bins) / width : 0;
    }
  }
  int bin(const Box& box, int axis) const {
    return std::clamp(int((box.center2(axis) - low[axis]) * scale[axis]), 0, bins - 1);
  }
};

/// Bounds and counts are exact, so that the order of summation does not matter.
struct Filling {
  Box box[3][mostBins];
  std::uint32_t count[3][mostBins] = {};

  void add(const Grid& grid, const Box& b) {
    for (int a = 0; a < 3; ++a) {
      int const k = grid.bin(b, a);
      box[a][k].grow(b);
      ++count[a][k];
    }
  }
  void join(const Filling& other, int bins) {
    for (int a = 0; a < 3; ++a)
      for (int k = 0; k < bins; ++k) {
        box[a][k].grow(other.box[a][k]);
        count[a][k] += other.count[a][k];
      }
  }
};

template <class Value, class Add, class Join>
Value reduce(std::span<const std::uint32_t> list, const Add& add, const Join& join) {
  auto const body = [&](const Range& range, Value sum) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) add(sum, list[i]);
    return sum;
  };
  if (list.size() < parallelFrom) return body(Range(0, list.size()), Value{});
  return oneapi::tbb::parallel_reduce(Range(0, list.size(), parallelFrom / 4), Value{}, body, join);
}

/// A split before bin `bin`; `at` counts the primitives to its left.
struct BinSplit : Split {
  int bin = 0;
};

void sweep(const Filling& filling, int axis, int bins, BinSplit& best) {
  std::array<float, mostBins> suffix{};
  std::array<std::uint32_t, mostBins> rest{};
  Box right, left;
  std::uint32_t count = 0;
  for (int k = bins - 1; k > 0; --k) {
    right.grow(filling.box[axis][k]);
    count += filling.count[axis][k];
    rest[std::size_t(k)] = count;
    suffix[std::size_t(k)] = count > 0 ? right.area() * float(count) : 0;
  }
  count = 0;
  for (int k = 1; k < bins; ++k) {
    left.grow(filling.box[axis][k - 1]);
    count += filling.count[axis][k - 1];
    if (count == 0 || rest[std::size_t(k)] == 0) continue;
    float const cost = left.area() * float(count) + suffix[std::size_t(k)];
    if (cost < best.cost) best = {{cost, axis, count}, k};
  }
}

}  // namespace

Split divideByBins(const Primitives& primitives, std::span<std::uint32_t> list, int bins, float limit, Box halves[2]) {
  const std::vector<Box>& boxes = primitives.box;
  bins = std::clamp(bins, 2, int(mostBins));
  Box const centers = reduce<Box>(
      list,
      [&](Box& sum, std::uint32_t p) {
        for (int a = 0; a < 3; ++a) {
          sum.min[a] = std::min(sum.min[a], boxes[p].center2(a));
          sum.max[a] = std::max(sum.max[a], boxes[p].center2(a));
        }
      },
      [](const Box& a, const Box& b) { return unite(a, b); });
  Grid const grid(centers, bins);
  Filling const filling = reduce<Filling>(
      list, [&](Filling& sum, std::uint32_t p) { sum.add(grid, boxes[p]); },
      [&](Filling a, const Filling& b) {
        a.join(b, bins);
        return a;
      });
  BinSplit best;
  best.cost = limit;
  for (int axis = 0; axis < 3; ++axis)
    if (grid.scale[axis] > 0) sweep(filling, axis, bins, best);
  if (best.axis < 0) return best;
  std::stable_partition(list.begin(), list.end(),
                        [&](std::uint32_t p) { return grid.bin(boxes[p], best.axis) < best.bin; });
  halves[0] = halves[1] = Box{};
  for (int k = 0; k < bins; ++k) halves[k >= best.bin].grow(filling.box[best.axis][k]);
  return best;
}

}  // namespace ropelight::bvh
