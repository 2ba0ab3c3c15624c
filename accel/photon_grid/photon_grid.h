#pragma once
// Photons in a uniform grid: dense where all cells of the scene fit the table, else hashed by row. Cells that are
// neighbours along x are neighbours in the table, so that a query reads a few runs of consecutive photons.

#include "accel/photon_grid/photon.h"
#include "render/core/rng.h"
#include "render/core/span.h"

namespace ropelight::RL_TARGET {

/// All photons looked for lie in this box about p and, up to rounding, in this ball about p.
struct Neighbourhood {
  Vec3 p;
  Vec3 extent;  ///< half the box's edges
  Real radius2;
};

/// Nothing here needs cell numbers to be exact: they are a monotone function of the coordinate, the same for photons
/// and queries, and photons beyond the bounds belong to the border's cells.
struct PhotonGrid {
  Vec3 origin{0};
  Vec3 edge{1};  ///< of a cell
  Vec3 inverseEdge{1};
  Vec3 slack{0};            ///< more than rounding can move a cell's border, in scene units
  int size[3] = {1, 1, 1};  ///< cells along each axis
  std::uint32_t cells = 1;  ///< of the table: all of them where dense, else a power of two
  bool dense = true;
  Span<const std::uint32_t> starts;  ///< cells + 1 entries: first photon of each cell
  Span<const PhotonPosition> positions;
  Span<const PhotonPower> powers;
  Span<const std::uint32_t> directions;  ///< packed, to where each came from; empty where no surface asks

  RL_HD int cellOf(Real x, int axis) const {
    Real const c = (x - origin[axis]) * inverseEdge[axis];
    return int(minOf(maxOf(c, Real(0)), Real(size[axis] - 1)));  // truncation is the floor of what is left
  }

  /// Table entry of the cell (0, y, z); cells of the row follow it, modulo the table.
  RL_HD std::uint32_t rowStart(int y, int z) const {
    if (dense) return (std::uint32_t(z) * std::uint32_t(size[1]) + std::uint32_t(y)) * std::uint32_t(size[0]);
    return hashCombine(std::uint32_t(y), std::uint32_t(z));
  }

  RL_HD std::uint32_t key(Vec3 p) const {
    std::uint32_t const k = rowStart(cellOf(p.y, 1), cellOf(p.z, 2)) + std::uint32_t(cellOf(p.x, 0));
    return dense ? k : k & (cells - 1);
  }

  /// Calls take(k, value, position) once for every photon k near n.p for which test(position, value) is true, and for
  /// none outside the neighbourhood unless test finds it there by rounding. Ascending in k where the grid is dense.
  template <class Test, class Take>
  RL_HD void forEachNear(const Neighbourhood& n, Test&& test, Take&& take) const {
    if (!isFinite(n.p)) return;  // would visit all cells
    Axis const y(*this, n, 1), z(*this, n, 2);
    Real const reachX = reach(n.p.x, n.extent.x), radius2 = n.radius2 * Real(1.00001);
    for (int cz = z.low; cz <= z.high; ++cz) {
      Real const rest = radius2 - square(z.gap(cz));
      for (int cy = y.low; cy <= y.high; ++cy) {
        Real const chord2 = rest - square(y.gap(cy));
        if (chord2 < 0) continue;  // the row passes by the ball
        Real const half = minOf(reach(n.p.x, sqrt(chord2)), reachX);
        visitRow(cy, cz, cellOf(n.p.x - half, 0), cellOf(n.p.x + half, 0), test, take);
      }
    }
  }

 private:
  /// The cells that a query covers along y or z, and how far it is from each.
  struct Axis {
    int low, high;
    Real at, edge, slack;  ///< at: the query's place, moved into the grid

    RL_HD Axis(const PhotonGrid& g, const Neighbourhood& n, int axis) : edge(g.edge[axis]), slack(g.slack[axis]) {
      Real const half = reach(n.p[axis], n.extent[axis]);
      low = g.cellOf(n.p[axis] - half, axis);
      high = g.cellOf(n.p[axis] + half, axis);
      at = minOf(maxOf(n.p[axis] - g.origin[axis], Real(0)), Real(g.size[axis]) * edge);
    }

    /// A lower bound on the distance to every photon of the cell, those beyond the bounds included.
    RL_HD Real gap(int cell) const {
      Real const below = Real(cell) * edge - at;
      return maxOf(maxOf(below, -(below + edge)) - slack, Real(0));
    }
  };

  /// A distance, increased by what rounding can add at the coordinate x.
  RL_HD static Real reach(Real x, Real extent) { return extent * Real(1.00001) + abs(x) * (4 * machineEpsilon); }

  /// A hashed row may wrap round the end of the table.
  template <class Test, class Take>
  RL_HD void visitRow(int y, int z, int low, int high, Test& test, Take& take) const {
    std::uint32_t first = rowStart(y, z) + std::uint32_t(low), span = std::uint32_t(high - low);
    if (!dense) {
      first &= cells - 1;
      if (span >= cells) {
        first = 0;
        span = cells - 1;
      }
    }
    for (;;) {
      bool const wraps = first + span >= cells;
      visitRun(y, z, starts[first], starts[wraps ? cells : first + span + 1], test, take);
      if (!wraps) return;
      span -= cells - first;
      first = 0;
    }
  }

  template <class Test, class Take>
  RL_HD void visitRun(int y, int z, std::uint32_t begin, std::uint32_t end, Test& test, Take& take) const {
    for (std::uint32_t k = begin; k < end; ++k) {
      PhotonPosition const photon = positions[k];
      Real value;
      if (test(photon, value) && belongs(photon.p, y, z)) take(k, value, photon);
    }
  }

  /// A bucket of a hashed grid may hold photons of other rows. They are skipped here, or a photon might be taken twice.
  RL_HD bool belongs(Vec3 p, int y, int z) const {
    return dense || (cellOf(p.y, 1) == y && cellOf(p.z, 2) == z) || faulty(Fault::foreignRows);
  }
};

}  // namespace ropelight::RL_TARGET
