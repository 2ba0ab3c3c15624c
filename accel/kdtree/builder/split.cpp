#include "accel/kdtree/builder/split.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <array>
#include <vector>

namespace ropelight {
namespace {

constexpr std::size_t grain = 4096;  ///< items below which a loop is not shared among threads

using Range = oneapi::tbb::blocked_range<std::size_t>;

KdBox boundsOf(std::span<const KdItem> items) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  KdBox const none{{inf, inf, inf}, {-inf, -inf, -inf}};
  auto const add = [&](const Range& range, KdBox box) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) grow(box, items[i].bounds);
    return box;
  };
  auto const join = [](KdBox a, const KdBox& b) {
    grow(a, b);
    return a;
  };
  if (items.size() <= grain) return add(Range(0, items.size()), none);
  return oneapi::tbb::parallel_reduce(Range(0, items.size(), grain), none, add, join);
}

/// How many items begin and end in each bin, by axis.
class Histogram {
 public:
  Histogram(const KdBox& bounds, int bins) : bounds_(bounds), bins_(bins), counts_(6 * std::size_t(bins), 0) {
    for (int a = 0; a < 3; ++a) {
      float const scale = float(bins) / (bounds.max[a] - bounds.min[a]);
      scale_[a] = std::isfinite(scale) ? scale : 0;
    }
  }

  void add(const KdItem& item) {
    for (int a = 0; a < 3; ++a) {
      ++begins(a)[bin((item.bounds.min[a] - bounds_.min[a]) * scale_[a])];
      ++ends(a)[std::size_t(bins_ - 1) - bin((bounds_.max[a] - item.bounds.max[a]) * scale_[a])];
    }
  }

  void add(const Histogram& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  }

  void consider(std::size_t items, int axis, KdHeuristic& heuristic) {
    double const lo = double(bounds_.min[axis]), width = bounds_.extent(axis);
    std::size_t low = 0, high = items;
    heuristic.consider(axis, bounds_.min[axis], low, high);
    for (int k = 1; k < bins_; ++k) {
      low += begins(axis)[k - 1];
      high -= ends(axis)[k - 1];
      heuristic.consider(axis, float(lo + width * k / bins_), low, high);
    }
    heuristic.consider(axis, bounds_.max[axis], items, 0);
  }

 private:
  std::uint32_t* begins(int axis) { return counts_.data() + std::ptrdiff_t(2 * axis) * bins_; }
  std::uint32_t* ends(int axis) { return begins(axis) + bins_; }
  std::size_t bin(float x) const { return std::size_t(std::clamp(int(x), 0, bins_ - 1)); }

  KdBox bounds_;
  int bins_;
  float scale_[3];
  std::vector<std::uint32_t> counts_;
};

}  // namespace

KdPlane middlePlane(const KdBox& cell) {
  double const x = cell.extent(0), y = cell.extent(1), z = cell.extent(2);
  int const axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  KdPlane const plane{axis, float(0.5 * (double(cell.min[axis]) + double(cell.max[axis])))};
  return plane.splits(cell) ? plane : KdPlane{};
}

void considerBins(std::span<const KdItem> items, int bins, KdHeuristic& heuristic) {
  Histogram const none(boundsOf(items), bins);
  auto const add = [&](const Range& range, Histogram h) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) h.add(items[i]);
    return h;
  };
  auto const join = [](Histogram a, const Histogram& b) {
    a.add(b);
    return a;
  };
  Range const all(0, items.size(), grain);
  Histogram histogram = items.size() <= grain ? add(all, none) : oneapi::tbb::parallel_reduce(all, none, add, join);
  for (int axis = 0; axis < 3; ++axis) histogram.consider(items.size(), axis, heuristic);
}

void considerAll(std::span<const KdItem> items, KdHeuristic& heuristic) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  std::array<float, fewItems> begins, ends;  // of a fixed length, so that loops over them become vector instructions
  auto const consider = [&](int axis, float s) {
    if (!heuristic.splits(axis, s)) return;
    std::uint32_t low = 0, high = 0;
    for (std::size_t i = 0; i < fewItems; ++i) {
      low += begins[i] < s;
      high += ends[i] > s;
    }
    heuristic.consider(axis, s, low, high);
  };
  for (int axis = 0; axis < 3; ++axis) {
    begins.fill(inf);
    ends.fill(-inf);
    for (std::size_t i = 0; i < items.size(); ++i) {
      begins[i] = items[i].bounds.min[axis];
      ends[i] = items[i].bounds.max[axis];
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
      consider(axis, begins[i]);
      consider(axis, ends[i]);
    }
  }
}

}  // namespace ropelight
