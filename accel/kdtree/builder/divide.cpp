#include "accel/kdtree/builder/divide.h"

#include <oneapi/tbb/parallel_for.h>

#include <span>
#include <utility>

namespace ropelight {
namespace {

constexpr std::size_t chunkSize = 4096;

/// Empty, with the cells of the two halves.
KdDivision cellsOnly(const KdBox& cell, const KdPlane& plane) {
  KdDivision d;
  d.half[0].cell = d.half[1].cell = cell;
  d.half[0].cell.max[plane.axis] = d.half[1].cell.min[plane.axis] = plane.position;
  return d;
}

/// The parts of an item that the plane cuts.
void addParts(const KdParts& parts, bool follow, KdDivision& d) {
  for (int h = 0; h < 2; ++h) {
    if (!parts.present[h]) continue;
    KdHalf& half = d.half[h];
    if (follow) half.cutItems.push_back(std::uint32_t(half.items.size()));
    half.items.push_back(parts.item[h]);
  }
  if (follow) d.destination.push_back(KdDivision::wasCut);
}

void addWhole(const KdItem& item, int h, bool follow, KdDivision& d) {
  std::vector<KdItem>& items = d.half[h].items;
  if (follow) d.destination.push_back(std::uint32_t(items.size()) << 1 | std::uint32_t(h));
  items.push_back(item);
}

void divideChunk(std::span<const KdItem> items, const KdBox& cell, const KdPlane& plane, const KdClipper& clipper,
                 bool follow, KdDivision& d) {
  if (follow) d.destination.reserve(items.size());
  for (const KdItem& item : items) {
    bool const low = item.bounds.min[plane.axis]<plane.position, high = item.bounds.max[plane.axis]> plane.position;
    if (low && high)
      addParts(clipper.divide(item, cell, plane.axis, plane.position), follow, d);
    else
      addWhole(item, low ? 0 : 1, follow, d);
  }
}

void append(KdDivision& d, const KdDivision& chunk) {
  std::uint32_t const first[2] = {std::uint32_t(d.half[0].items.size()), std::uint32_t(d.half[1].items.size())};
  for (std::uint32_t to : chunk.destination)
    d.destination.push_back(to == KdDivision::wasCut ? to : to + (first[to & 1u] << 1));
  for (int h = 0; h < 2; ++h) {
    const KdHalf& from = chunk.half[h];
    for (std::uint32_t i : from.cutItems) d.half[h].cutItems.push_back(first[h] + i);
    d.half[h].items.insert(d.half[h].items.end(), from.items.begin(), from.items.end());
  }
}

}  // namespace

KdDivision divide(const std::vector<KdItem>& items, const KdBox& cell, const KdPlane& plane, const KdClipper& clipper,
                  bool follow) {
  KdDivision whole = cellsOnly(cell, plane);
  if (items.size() <= chunkSize) {
    divideChunk(items, cell, plane, clipper, follow, whole);
    return whole;
  }
  std::vector<KdDivision> chunks((items.size() + chunkSize - 1) / chunkSize, whole);
  oneapi::tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t c) {
    std::size_t const first = c * chunkSize;
    divideChunk(std::span(items).subspan(first, std::min(chunkSize, items.size() - first)), cell, plane, clipper,
                follow, chunks[c]);
  });
  std::size_t sizes[2] = {0, 0};
  for (const KdDivision& chunk : chunks)
    for (int h = 0; h < 2; ++h) sizes[h] += chunk.half[h].items.size();
  for (int h = 0; h < 2; ++h) whole.half[h].items.reserve(sizes[h]);
  if (follow) whole.destination.reserve(items.size());
  for (KdDivision& chunk : chunks) append(whole, std::exchange(chunk, {}));
  return whole;
}

}  // namespace ropelight
