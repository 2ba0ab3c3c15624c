#include "accel/bvh/sweep.h"

#include <oneapi/tbb/task_arena.h>

#include <bit>
#include <cstring>
#include <numeric>

#include "render/core/radix_sort.h"

namespace ropelight::bvh {
namespace {

/// Unsigned integers in the order of the floats.
std::uint32_t sortKey(float x) {
  std::uint32_t const bits = std::bit_cast<std::uint32_t>(x);
  return bits >> 31 ? ~bits : bits | 0x80000000u;
}

}  // namespace

SortedLists::SortedLists(const Primitives& primitives) : primitives_(primitives), isLeft_(primitives.size()) {
  for (int axis = 0; axis < 3; ++axis) {
    order_[axis].resize(primitives.size());
    scratch_[axis].resize(primitives.size());
    suffix_[axis].resize(primitives.size());
    std::iota(order_[axis].begin(), order_[axis].end(), 0u);
  }
}

void SortedLists::sortAll() {
  int const threads = oneapi::tbb::this_task_arena::max_concurrency();
  std::uint32_t const n = primitives_.size();
  std::vector<std::uint32_t> keys(n), keyScratch(n);
  for (int axis = 0; axis < 3; ++axis) {
    oneapi::tbb::parallel_for(0u, n, [&](std::uint32_t i) { keys[i] = sortKey(primitives_.box[i].center2(axis)); });
    radixSortPairs(keys.data(), order_[axis].data(), keyScratch.data(), scratch_[axis].data(), n, 32, threads);
  }
}

void SortedLists::sort(std::uint32_t begin, std::uint32_t end) {
  for (int axis = 2; axis >= 0; --axis) {
    if (axis > 0) std::copy(order_[0].begin() + begin, order_[0].begin() + end, order_[axis].begin() + begin);
    std::sort(order_[axis].begin() + begin, order_[axis].begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      float const x = primitives_.box[a].center2(axis), y = primitives_.box[b].center2(axis);
      return x < y || (x == y && a < b);
    });
  }
}

Split SortedLists::best(std::uint32_t begin, std::uint32_t end, float limit) {
  Split found[3] = {{limit}, {limit}, {limit}};
  if (end - begin < parallelFrom) {
    for (int axis = 0; axis < 3; ++axis) sweep(axis, begin, end, found[0]);
    return found[0];
  }
  oneapi::tbb::parallel_for(0, 3, [&](int axis) { sweep(axis, begin, end, found[axis]); });
  Split best = found[0];
  for (int axis = 1; axis < 3; ++axis)
    if (found[axis].cost < best.cost) best = found[axis];
  return best;
}

/// Both sides' costs grow with the side, so that each pass ends where one side alone costs more than the best.
void SortedLists::sweep(int axis, std::uint32_t begin, std::uint32_t end, Split& best) {
  const std::uint32_t* order = order_[axis].data();
  const Box* boxes = primitives_.box.data();
  float* suffix = suffix_[axis].data();
  Box right;
  std::uint32_t first = end;
  while (first > begin + 1) {
    right.grow(boxes[order[first - 1]]);
    float const cost = right.area() * float(end - first + 1);
    if (cost >= best.cost) break;
    suffix[--first] = cost;
  }
  Box left;
  std::uint32_t at = begin;
  while (at + 1 < first) left.grow(boxes[order[at++]]);
  while (at + 1 < end) {
    left.grow(boxes[order[at++]]);
    float const cost = left.area() * float(at - begin);
    if (cost >= best.cost) return;
    if (cost + suffix[at] < best.cost) best = {cost + suffix[at], axis, at};
  }
}

Split SortedLists::median(std::uint32_t begin, std::uint32_t end) const {
  Split split{-1, 0, begin + (end - begin) / 2};
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<std::uint32_t>& order = order_[axis];
    float const spread = primitives_.box[order[end - 1]].center2(axis) - primitives_.box[order[begin]].center2(axis);
    if (spread > split.cost) split.axis = axis, split.cost = spread;
  }
  return split;
}

void SortedLists::partition(std::uint32_t begin, std::uint32_t end, const Split& split, Box halves[2]) {
  halves[0] = mark(order_[split.axis], begin, split.at, true);
  halves[1] = mark(order_[split.axis], split.at, end, false);
  auto const others = [&](int axis) {
    if (axis != split.axis) divide(axis, begin, end);
  };
  eachAxis(end - begin, others);
}

Box SortedLists::mark(const std::vector<std::uint32_t>& list, std::uint32_t begin, std::uint32_t end, bool left) {
  Box box;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.grow(primitives_.box[list[i]]);
    isLeft_[list[i]] = left;
  }
  return box;
}

/// Without branches: every element is written to both sides, and one of them keeps it.
void SortedLists::divide(int axis, std::uint32_t begin, std::uint32_t end) {
  std::uint32_t* order = order_[axis].data();
  std::uint32_t* scratch = scratch_[axis].data() + begin;
  std::uint32_t left = begin, right = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    std::uint32_t const p = order[i], isLeft = isLeft_[p];
    order[left] = scratch[right] = p;
    left += isLeft;
    right += 1 - isLeft;
  }
  std::memcpy(order + left, scratch, right * sizeof(std::uint32_t));
}

}  // namespace ropelight::bvh
