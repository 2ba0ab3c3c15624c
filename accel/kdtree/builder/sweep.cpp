#include "accel/kdtree/builder/sweep.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <bit>

namespace ropelight {
namespace {

constexpr std::size_t parallelSize = 8192;  ///< events below which one thread does all axes

template <class Work>
void forAxes(std::size_t events, const Work& work) {
  if (events >= parallelSize) return oneapi::tbb::parallel_for(0, 3, work);
  for (int axis = 0; axis < 3; ++axis) work(axis);
}

void addEvents(const KdItem& item, std::uint32_t index, int axis, std::vector<KdEvent>& events) {
  events.emplace_back(item.bounds.min[axis], true, index);
  events.emplace_back(item.bounds.max[axis], false, index);
}

void sort(std::vector<KdEvent>& events) {
  if (events.size() >= parallelSize) return oneapi::tbb::parallel_sort(events.begin(), events.end());
  std::sort(events.begin(), events.end());
}

void considerAxis(const std::vector<KdEvent>& events, int axis, KdHeuristic& heuristic) {
  std::size_t low = 0, high = events.size() / 2;
  for (std::size_t i = 0; i < events.size();) {
    float const position = events[i].position();
    std::size_t begins = 0;
    for (; i < events.size() && events[i].position() == position; ++i) {
      if (events[i].begin())
        ++begins;
      else
        --high;
    }
    heuristic.consider(axis, position, low, high);
    low += begins;
  }
}

/// Events of the items that were not cut keep their order; those of cut items are made again and merged in.
std::vector<KdEvent> eventsOfHalf(const std::vector<KdEvent>& events, const KdDivision& division, int half, int axis) {
  const KdHalf& to = division.half[half];
  std::vector<KdEvent> kept, cut, merged;
  kept.reserve(2 * (to.items.size() - to.cutItems.size()));
  for (const KdEvent& e : events) {
    std::uint32_t const destination = division.destination[e.item()];
    if (destination != KdDivision::wasCut && int(destination & 1u) == half) kept.push_back(e.of(destination >> 1));
  }
  if (to.cutItems.empty()) return kept;
  cut.reserve(2 * to.cutItems.size());
  for (std::uint32_t i : to.cutItems) addEvents(to.items[i], i, axis, cut);
  sort(cut);
  merged.resize(kept.size() + cut.size());
  std::merge(kept.begin(), kept.end(), cut.begin(), cut.end(), merged.begin());
  return merged;
}

}  // namespace

/// Maps the bits of a float to unsigned integers in the same order.
std::uint32_t KdEvent::ordered(float position) {
  std::uint32_t const bits = std::bit_cast<std::uint32_t>(position);
  return bits ^ (bits >> 31 ? 0xFFFFFFFFu : 0x80000000u);
}

float KdEvent::position() const {
  std::uint32_t const key = std::uint32_t(key_ >> 32);
  return std::bit_cast<float>(key ^ (key >> 31 ? 0x80000000u : 0xFFFFFFFFu));
}

KdEvents::KdEvents(const std::vector<KdItem>& items) {
  forAxes(2 * items.size(), [&](int axis) {
    axis_[axis].reserve(2 * items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) addEvents(items[i], i, axis, axis_[axis]);
    sort(axis_[axis]);
  });
}

void KdEvents::considerAll(KdHeuristic& heuristic) const {
  KdHeuristic ofAxis[3] = {heuristic, heuristic, heuristic};
  forAxes(axis_[0].size(), [&](int axis) { considerAxis(axis_[axis], axis, ofAxis[axis]); });
  for (const KdHeuristic& h : ofAxis) heuristic.consider(h.best());
}

KdEvents KdEvents::ofHalf(const KdDivision& division, int half) const {
  KdEvents events;
  forAxes(axis_[0].size(), [&](int axis) { events.axis_[axis] = eventsOfHalf(axis_[axis], division, half, axis); });
  return events;
}

}  // namespace ropelight
