#pragma once
// Photons in a uniform grid: dense where all cells of the scene fit the table, else hashed by row. Cells that are
// neighbours along x are neighbours in the table, so that a query reads a few runs of consecutive photons.

#include "render/core/numeric.h"
#include "render/core/rng.h"
#include "render/core/span.h"

namespace ropelight::RL_TARGET {

/// Octahedral encoding of a unit vector in 2×16 bits (Cigolle et al. 2014); the error is below 10⁻⁴ rad.
RL_HD inline std::uint32_t packDirection(Vec3 v) {
  Real const scale = 1 / (abs(v.x) + abs(v.y) + abs(v.z));
  Real x = v.x * scale, y = v.y * scale;
  if (v.z < 0) {
    Real const fold = (1 - abs(y)) * copysign(Real(1), x);
    y = (1 - abs(x)) * copysign(Real(1), y);
    x = fold;
  }
  auto const quantise = [](Real t) { return std::uint32_t((t * Real(0.5) + Real(0.5)) * Real(65535) + Real(0.5)); };
  return quantise(x) << 16 | quantise(y);
}

RL_HD inline Vec3 unpackDirection(std::uint32_t bits) {
  Real x = Real(bits >> 16) * Real(2.0 / 65535) - 1, y = Real(bits & 0xFFFFu) * Real(2.0 / 65535) - 1;
  Real const z = 1 - abs(x) - abs(y);
  if (z < 0) {
    Real const fold = (1 - abs(y)) * copysign(Real(1), x);
    y = (1 - abs(x)) * copysign(Real(1), y);
    x = fold;
  }
  return normalize(Vec3(x, y, z));
}

/// What the distance test reads. normal: packed, on the side that the photon arrived from.
struct PhotonPosition {
  Vec3 p;
  std::uint32_t normal;
};

/// What an accepted photon adds. flux: watts. edges: of its path from the light. caustic: 1 where all earlier bounces
/// were specular, and there was one.
struct PhotonPower {
  Rgb flux;
  std::uint32_t edges : 31 = 0;
  std::uint32_t caustic : 1 = 0;
};

struct CellRange {
  int low[3], high[3];  ///< inclusive
};

struct PhotonGrid {
  Vec3 origin{0};
  Real inverseCell = 1;
  int size[3] = {1, 1, 1};  ///< cells along each axis
  std::uint32_t cells = 1;  ///< of the table: all of them where dense, else a power of two
  bool dense = true;
  Span<const std::uint32_t> starts;  ///< cells + 1 entries: first photon of each cell
  Span<const PhotonPosition> positions;
  Span<const PhotonPower> powers;

  RL_HD int cellOf(Real x, int axis) const {
    Real const c = (x - origin[axis]) * inverseCell;
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

  /// Cells that hold every photon within `extent` of p along each axis, whatever the rounding.
  RL_HD CellRange around(Vec3 p, Vec3 extent) const {
    CellRange r;
    for (int a = 0; a < 3; ++a) {
      Real const reach = extent[a] * Real(1.00001) + abs(p[a]) * (4 * machineEpsilon);
      r.low[a] = cellOf(p[a] - reach, a);
      r.high[a] = cellOf(p[a] + reach, a);
    }
    return r;
  }

  /// Calls visit(k) once for every photon k in the cells of the range, in ascending order of the table by rows.
  template <class Visit>
  RL_HD void forEachIn(const CellRange& r, Visit&& visit) const {
    for (int z = r.low[2]; z <= r.high[2]; ++z)
      for (int y = r.low[1]; y <= r.high[1]; ++y) {
        std::uint32_t const row = rowStart(y, z);
        if (dense)
          visitRun(row + std::uint32_t(r.low[0]), row + std::uint32_t(r.high[0]), visit);
        else
          visitHashedRow(r, y, z, row, visit);
      }
  }

 private:
  template <class Visit>
  RL_HD void visitRun(std::uint32_t first, std::uint32_t last, Visit&& visit) const {
    for (std::uint32_t k = starts[first], end = starts[last + 1]; k < end; ++k) visit(k);
  }

  /// A bucket may hold photons of other cells: their coordinates decide, so that none is seen twice.
  template <class Visit>
  RL_HD void visitHashedRow(const CellRange& r, int y, int z, std::uint32_t row, Visit& visit) const {
    std::uint32_t const span = std::uint32_t(r.high[0] - r.low[0]);
    std::uint32_t const first = (row + std::uint32_t(r.low[0])) & (cells - 1);
    auto const checked = [&](std::uint32_t k) {
      Vec3 const p = positions[k].p;
      int const x = cellOf(p.x, 0);
      if (cellOf(p.y, 1) == y && cellOf(p.z, 2) == z && x >= r.low[0] && x <= r.high[0]) visit(k);
    };
    if (span >= cells) return visitRun(0, cells - 1, checked);
    if (first + span < cells) return visitRun(first, first + span, checked);
    visitRun(first, cells - 1, checked);
    visitRun(0, first + span - cells, checked);
  }
};

}  // namespace ropelight::RL_TARGET
