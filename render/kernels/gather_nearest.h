#pragma once
// The k nearest photons in two readings of the disc and a few bytes of memory: the first counts photons by distance,
// the second adds up those nearer than the bin that holds the k-th and lists the few in it.

#include "render/kernels/gather_view.h"

namespace ropelight::RL_TARGET {

inline constexpr int nearestLimit = 128;

namespace nearest {

/// Photons in the order of nearness: squared distance in single precision (whose bits are in the order of its values),
/// then the number.
using Key = std::uint64_t;

RL_HD inline std::uint32_t bitsOf(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

RL_HD inline float floatOf(std::uint32_t bits) {
  float x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

RL_HD inline Key keyOf(Real distance2, std::uint32_t photon) { return Key(bitsOf(float(distance2))) << 32 | photon; }

RL_HD inline int bitWidth(Key x) {
  int width = 0;
  for (; x != 0; x >>= 1) ++width;
  return width;
}

inline constexpr int binBits = 6, bins = 1 << binBits;
/// Photons of one bin that are listed; a bin with more is divided into bins again.
inline constexpr int listed = 16;

/// Counts that stop at 255, more than any k.
struct Histogram {
  std::uint8_t count[bins];

  RL_HD Histogram() {
    for (std::uint8_t& c : count) c = 0;
  }
  RL_HD void add(int bin) {
    std::uint32_t const c = count[bin];
    count[bin] = std::uint8_t(c + (c < 255 ? 1 : 0));
  }
  /// The bin that holds the k-th, or `bins`; k becomes its place in it, or what is missing.
  RL_HD int find(int& k) const {
    int bin = 0;
    for (; bin < bins && int(count[bin]) < k; ++bin) k -= int(count[bin]);
    return bin;
  }
};

/// Bins of equal width over the squared distance: about equally full on a surface.
struct Rings {
  float scale;

  RL_HD explicit Rings(Real radius) : scale(float(bins) / float(radius * radius)) {}
  RL_HD int binOf(float distance2) const {
    float const ring = distance2 * scale;
    return ring < float(bins - 1) ? int(ring) : bins - 1;
  }
  /// Bits of the least distance in the bin or beyond it.
  RL_HD std::uint32_t lowest(int bin) const {
    if (bin == 0) return 0;
    std::uint32_t bits = bitsOf(float(bin) / scale);
    while (bits > 0 && binOf(floatOf(bits - 1)) >= bin) --bits;
    while (binOf(floatOf(bits)) < bin) ++bits;
    return bits;
  }
};

/// Where the k-th is: `place`-th (from 1) of the `count` keys in [low, high].
struct Range {
  Key low = 0, high = ~Key(0);
  int place = 0, count = 0;

  /// The squared distance of the farthest key, and no more than the disc has.
  RL_HD Real most(Real disc2) const {
    std::uint32_t const bits = std::uint32_t(high >> 32);
    return bits < bitsOf(float(disc2)) ? Real(floatOf(bits)) : disc2;
  }
};

/// k photons and more on the disc: a range that holds the k-th and at most `listed` keys. None: place is 0.
RL_HD inline Range findRange(const GatherView& view, const GatherPoint& g, int k) {
  Rings const rings(view.radius);
  Range range;
  range.place = k;
  int shift = -1;  // rings first, then keys without their low bits
  do {
    Histogram counts;
    view.forEachOnDisc(g, range.most(square(view.radius)),
                       [&](std::uint32_t photon, Real distance2, const PhotonPower&) {
                         Key const key = keyOf(distance2, photon);
                         if (key < range.low || key > range.high) return;
                         counts.add(shift < 0 ? rings.binOf(float(distance2)) : int((key - range.low) >> shift));
                       });
    int const bin = counts.find(range.place);
    if (bin == bins) return Range{~Key(0)};
    range.count = int(counts.count[bin]);
    if (shift < 0) {
      if (bin + 1 < bins) range.high = (Key(rings.lowest(bin + 1)) << 32) - 1;
      range.low = Key(rings.lowest(bin)) << 32;
    } else {
      range.low += Key(bin) << shift;
      range.high = range.low + ((Key(1) << shift) - 1);
    }
    int const width = bitWidth(range.high - range.low);
    shift = width > binBits ? width - binBits : 0;
  } while (range.count > listed);
  return range;
}

}  // namespace nearest

/// The k nearest within the radius: k − 1 photons over the disc of the k-th distance, which is unbiased where k over it
/// is not; with fewer than k found, all over the full disc. Added up in the order of the grid, but for the last few,
/// which follow in the order of nearness.
RL_HD inline Gathering gatherNearest(const GatherView& view, const GatherPoint& g, int k) {
  using namespace nearest;
  Range const range = findRange(view, g, k);
  Gathering sum;
  Key list[listed] = {};  // in order
  int count = 0;
  view.forEachOnDisc(g, range.most(square(view.radius)),
                     [&](std::uint32_t photon, Real distance2, const PhotonPower& power) {
                       Key const key = keyOf(distance2, photon);
                       if (key < range.low) {
                         sum.flux += power.flux;
                         ++sum.count;
                       } else if (key <= range.high) {
                         int i = count++;
                         for (; i > 0 && list[i - 1] > key; --i) list[i] = list[i - 1];
                         list[i] = key;
                       }
                     });
  sum.radius2 = square(view.radius);
  sum.share = view.share(g, sum.radius2);
  if (range.place == 0) return sum;
  for (int i = 0; i + 1 < range.place; ++i) sum.flux += view.grid.powers[std::uint32_t(list[i])].flux;
  sum.count = std::uint32_t(k);
  sum.radius2 = Real(floatOf(std::uint32_t(list[range.place - 1] >> 32)));
  sum.share = view.share(g, sum.radius2);
  return sum;
}

}  // namespace ropelight::RL_TARGET
