#pragma once
// Splits between primitives sorted along each axis: the exact minimum of the surface-area heuristic over centroids.

#include <oneapi/tbb/parallel_for.h>

#include "accel/bvh/tree.h"

namespace ropelight::bvh {

/// Ranges of at least that many primitives are worth several threads at once.
inline constexpr std::uint32_t parallelFrom = 1u << 14;

/// Divides the range [begin, end) at `at`, along an axis. cost: of both halves, in area × primitives.
struct Split {
  float cost;
  int axis = -1;
  std::uint32_t at = 0;
};

/// Three lists of the same primitives, each in the order of centroids along its axis. Every node of the tree owns the
/// same range of all three, so that ranges can be worked on at the same time.
class SortedLists {
 public:
  explicit SortedLists(const Primitives& primitives);

  /// All lists at once.
  void sortAll();
  /// One range, as list 0 holds it. For ranges that are small.
  void sort(std::uint32_t begin, std::uint32_t end);

  /// The best split that costs less than `limit`; axis −1 where there is none.
  Split best(std::uint32_t begin, std::uint32_t end, float limit);
  /// Splits into equal numbers of primitives along the axis on which their centroids lie farthest apart.
  Split median(std::uint32_t begin, std::uint32_t end) const;
  /// Divides all lists, keeping their order; the boxes of the halves go to `halves`.
  void partition(std::uint32_t begin, std::uint32_t end, const Split& split, Box halves[2]);

  std::vector<std::uint32_t>& list(int axis) { return order_[axis]; }

 private:
  void sweep(int axis, std::uint32_t begin, std::uint32_t end, Split& best);
  void divide(int axis, std::uint32_t begin, std::uint32_t end);
  Box mark(const std::vector<std::uint32_t>& list, std::uint32_t begin, std::uint32_t end, bool left);

  /// Calls body(axis) for 0, 1, 2; at the same time where the range is worth it.
  template <class Body>
  static void eachAxis(std::uint32_t count, const Body& body) {
    if (count < parallelFrom)
      for (int axis = 0; axis < 3; ++axis) body(axis);
    else
      oneapi::tbb::parallel_for(0, 3, body);
  }

  const Primitives& primitives_;
  std::vector<std::uint32_t> order_[3], scratch_[3];
  std::vector<float> suffix_[3];      ///< area × primitives of what lies from here to the end of the range
  std::vector<std::uint8_t> isLeft_;  ///< by primitive, while its range is divided
};

}  // namespace ropelight::bvh
