#pragma once
// Density estimation at the gather points (Jensen 1996): flux over the disc's area, by radius or by k nearest.

#include "accel/photon_grid.h"
#include "render/backend/tally.h"
#include "render/integrator/stages/photon_store.h"
#include "render/integrator/stages/trace_camera.h"

namespace ropelight::RL_TARGET {

/// Height of the disc over its radius: photons of a wall nearer than this are told apart once the radius has shrunk.
inline constexpr Real discThickness = Real(0.2);
/// Photons count where their surface turns from the gather point's by less than acos of this.
inline constexpr Real sameSide = Real(0.1);
inline constexpr int nearestLimit = 128;

/// What the gather adds to the film: radiance, or what there is to see of the gather itself.
enum class Gathered : std::uint8_t { radiance, photonCount, radius };

struct GatherView {
  PhotonGrid grid;
  Real radius = 0;
  int maxDepth = 0;
  Gathered output = Gathered::radiance;

  /// Squared distance in the plane of the disc where photon k lies on it, else −1.
  RL_HD Real onDisc(const GatherPoint& g, std::uint32_t k) const {
    PhotonPosition const photon = grid.positions[k];
    Vec3 const d = photon.p - g.p;
    Real const height = dot(d, g.n);
    Real const distance2 = lengthSquared(d) - height * height;
    if (!(distance2 <= radius * radius) || abs(height) > discThickness * radius) return -1;
    bool const plane = photon.normal == g.packedNormal;  // the usual case, without decoding
    if (!plane && !(dot(unpackDirection(photon.normal), g.n) > sameSide)) return -1;
    return maxOf(distance2, Real(0));
  }

  /// Cells that the disc meets, with its thickness: tilted, it reaches up to 2% farther than its radius.
  RL_HD CellRange cells(const GatherPoint& g) const {
    Vec3 const n2 = g.n * g.n;
    Vec3 const across(sqrt(n2.y + n2.z), sqrt(n2.z + n2.x), sqrt(n2.x + n2.y));
    return grid.around(g.p, (across + absolute(g.n) * discThickness) * radius);
  }

  /// Adds an estimate from `count` photons over a disc of that squared radius and area.
  RL_HD void put(Rgb& film, const GatherPoint& g, Rgb flux, int count, Real radius2, Real inverseArea) const {
    if (output == Gathered::radiance) {
      if (radius2 > 0) film += g.weight * flux * float(inverseArea);
    } else if (output == Gathered::photonCount) {
      film += Rgb(float(count));
    } else {
      film = Rgb(float(sqrt(radius2)));
    }
  }

  RL_HD bool withinDepth(const GatherPoint& g, std::uint32_t k) const {
    return grid.powers[k].edges + g.edges <= std::uint32_t(maxDepth);
  }
};

/// All photons within the radius, over its full disc.
struct GatherRadius {
  static constexpr const char* name = "GatherRadius";
  static constexpr std::uint32_t grain = 512;

  GatherView view;
  Span<const GatherPoint> points;
  Span<Rgb> radiance;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (isBlack(g.weight)) return;
    Rgb flux(0.0f);
    int count = 0;
    view.grid.forEachIn(view.cells(g), [&](std::uint32_t k) {
      if (!(view.onDisc(g, k) >= 0) || !view.withinDepth(g, k)) return;
      flux += view.grid.powers[k].flux;
      ++count;
    });
    view.put(radiance[slot], g, flux, count, square(view.radius), invPi / square(view.radius));
  }
};

/// The k nearest within the radius: k − 1 photons over the disc of the k-th distance, which is unbiased where k over it
/// is not; with fewer than k found, all over the full disc.
struct GatherNearest {
  static constexpr const char* name = "GatherNearest";
  static constexpr std::uint32_t grain = 256;

  GatherView view;
  int k = 50;
  Span<const GatherPoint> points;
  Span<Rgb> radiance;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (isBlack(g.weight)) return;
    Heap heap;
    view.grid.forEachIn(view.cells(g), [&](std::uint32_t photon) {
      Real const distance2 = view.onDisc(g, photon);
      if (distance2 >= 0 && view.withinDepth(g, photon)) heap.offer(distance2, photon, k);
    });
    bool const full = heap.size == k;
    Rgb flux(0.0f);
    for (int i = full ? 1 : 0; i < heap.size; ++i) flux += view.grid.powers[heap.photon[i]].flux;
    Real const radius2 = full ? heap.distance2[0] : square(view.radius);
    view.put(radiance[slot], g, flux, heap.size, radius2, 1 / (pi * radius2));
  }

 private:
  /// A max-heap of (distance, photon); the farthest, and among equals the highest photon, is at 0.
  struct Heap {
    int size = 0;
    Real distance2[nearestLimit];
    std::uint32_t photon[nearestLimit];

    RL_HD bool less(int i, Real d, std::uint32_t p) const {
      return distance2[i] < d || (distance2[i] == d && photon[i] < p);
    }

    RL_HD void offer(Real d, std::uint32_t p, int k) {
      if (size < k) {
        int i = size++;
        for (; i > 0 && less((i - 1) / 2, d, p); i = (i - 1) / 2) move((i - 1) / 2, i);
        put(i, d, p);
      } else if (!less(0, d, p)) {
        sink(d, p);
      }
    }

    RL_HD void sink(Real d, std::uint32_t p) {
      int i = 0;
      for (int child = 1; child < size; child = 2 * i + 1) {
        if (child + 1 < size && less(child, distance2[child + 1], photon[child + 1])) ++child;
        if (!less(child, d, p)) {
          move(child, i);
          i = child;
        } else {
          break;
        }
      }
      put(i, d, p);
    }

    RL_HD void move(int from, int to) { put(to, distance2[from], photon[from]); }
    RL_HD void put(int i, Real d, std::uint32_t p) {
      distance2[i] = d;
      photon[i] = p;
    }
  };
};

}  // namespace ropelight::RL_TARGET
