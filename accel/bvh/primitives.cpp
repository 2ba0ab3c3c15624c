#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>

#include "accel/bvh/tree.h"
#include "render/core/radix_sort.h"

namespace ropelight::bvh {
namespace {

using Range = oneapi::tbb::blocked_range<std::uint32_t>;
constexpr std::uint32_t grain = 4096;
constexpr int mortonBits = 10;  // an axis

Box boxOf(const FlatScene& scene, std::uint32_t id, double pad, double scale) {
  Bounds const b = scene.primitiveBounds(id);
  Box box;
  for (int a = 0; a < 3; ++a) {
    box.min[a] = roundDown((b.min[a] - pad) * scale);
    box.max[a] = -roundDown((-b.max[a] - pad) * scale);
  }
  box.min[3] = box.max[3] = 0;
  return box;
}

std::uint32_t spread(std::uint32_t x) {  // two zeros between any two bits
  x = (x | x << 16) & 0x030000FFu;
  x = (x | x << 8) & 0x0300F00Fu;
  x = (x | x << 4) & 0x030C30C3u;
  return (x | x << 2) & 0x09249249u;
}

/// Places of box centres along the Morton curve.
class MortonCurve {
 public:
  explicit MortonCurve(const std::vector<Box>& boxes) {
    bounds_ = oneapi::tbb::parallel_reduce(
        Range(0, std::uint32_t(boxes.size()), grain), Box{},
        [&](const Range& range, Box sum) {
          for (std::uint32_t i = range.begin(); i != range.end(); ++i) sum.grow(boxes[i]);
          return sum;
        },
        [](const Box& a, const Box& b) { return unite(a, b); });
    float extent = 0;
    for (int a = 0; a < 3; ++a) extent = std::max(extent, bounds_.max[a] - bounds_.min[a]);
    if (extent > 0) cells_ = float(1 << mortonBits) / extent;
  }

  std::uint32_t operator()(const Box& box) const {
    std::uint32_t code = 0;
    for (int a = 0; a < 3; ++a) {
      int const cell = int((0.5f * box.center2(a) - bounds_.min[a]) * cells_);
      code |= spread(std::uint32_t(std::clamp(cell, 0, (1 << mortonBits) - 1))) << a;
    }
    return code;
  }

 private:
  Box bounds_;
  float cells_ = 0;
};

}  // namespace

Primitives preparePrimitives(const FlatScene& scene) {
  std::uint32_t const n = scene.primitiveCount();
  Primitives out;
  if (scene.reach > 0) out.shift = std::clamp(-std::ilogb(scene.reach), -120, 120);
  double const pad = std::ldexp(scene.reach, -20), scale = std::ldexp(1.0, out.shift);
  std::vector<Box> boxes(n);
  std::vector<std::uint32_t> keys(n), keyScratch(n), scratch(n);
  out.id.resize(n);
  out.box.resize(n);
  auto const each = [n](auto&& body) {
    oneapi::tbb::parallel_for(Range(0, n, grain), [&](const Range& range) {
      for (std::uint32_t i = range.begin(); i != range.end(); ++i) body(i);
    });
  };
  each([&](std::uint32_t i) { boxes[i] = boxOf(scene, i, pad, scale); });
  MortonCurve const curve(boxes);
  each([&](std::uint32_t i) {
    keys[i] = curve(boxes[i]);
    out.id[i] = i;
  });
  radixSortPairs(keys.data(), out.id.data(), keyScratch.data(), scratch.data(), n, 3 * mortonBits,
                 oneapi::tbb::this_task_arena::max_concurrency());
  each([&](std::uint32_t i) { out.box[i] = boxes[out.id[i]]; });
  return out;
}

}  // namespace ropelight::bvh
