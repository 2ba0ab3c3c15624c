#pragma once
// The exact surface-area heuristic in O(n log n): the planes at which items begin and end are sorted once and stay
// sorted as cells divide (Wald & Havran 2006, "On building fast kd-Trees for Ray Tracing, and on doing that in
// O(N log N)").

#include <vector>

#include "accel/kdtree/builder/divide.h"

namespace ropelight {

/// Where an item begins or ends along an axis. Keys ascend with the position; at the same one, ends come first.
class KdEvent {
 public:
  KdEvent() = default;
  KdEvent(float position, bool begin, std::uint32_t item)
      : key_(std::uint64_t(ordered(position)) << 32 | std::uint64_t(begin) << 31 | item) {}

  float position() const;
  bool begin() const { return (key_ >> 31 & 1u) != 0; }
  std::uint32_t item() const { return std::uint32_t(key_) & 0x7FFFFFFFu; }
  /// The same event after its item's index has changed.
  KdEvent of(std::uint32_t item) const {
    KdEvent e;
    e.key_ = (key_ & ~std::uint64_t(0x7FFFFFFF)) | item;
    return e;
  }
  bool operator<(const KdEvent& other) const { return key_ < other.key_; }

 private:
  static std::uint32_t ordered(float position);

  std::uint64_t key_ = 0;
};

/// The events of a cell's items, sorted; two per item along each axis.
class KdEvents {
 public:
  KdEvents() = default;
  explicit KdEvents(const std::vector<KdItem>& items);

  bool empty() const { return axis_[0].empty(); }
  /// Considers every plane at which an item begins or ends.
  void considerAll(KdHeuristic& heuristic) const;
  /// The events of one half of a division that followed its items.
  KdEvents ofHalf(const KdDivision& division, int half) const;

 private:
  std::vector<KdEvent> axis_[3];
};

}  // namespace ropelight
