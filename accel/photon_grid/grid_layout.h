#pragma once
// Which cells a photon grid has.

#include <algorithm>
#include <cmath>

#include "accel/photon_grid/photon_grid.h"
#include "render/scene/bounds.h"

namespace ropelight::RL_TARGET {

/// Cells are up to this many times shorter along x than along y and z. Short cells cost table entries but no more runs
/// to read, and runs that follow the disc's outline hold fewer photons that are not wanted.
inline constexpr double finestAlongX = 4;
/// Edges grow up to this many times the one asked for before rows are hashed.
inline constexpr double coarsestEdge = 4;

namespace detail {

inline std::uint32_t cellsAlong(double extent, double edge) {
  return std::uint32_t(std::min(std::floor(extent / edge) + 1, 1073741824.0));
}

/// Cells along x where a grid of that edge across is to fit the table; 0 where it does not with cells of that edge.
inline std::uint32_t denseAlongX(Vec3d extent, double cell, double edge, std::uint32_t table) {
  double const rows = double(cellsAlong(extent.y, edge)) * double(cellsAlong(extent.z, edge));
  double const room = std::floor(double(table) / rows);
  if (room < double(cellsAlong(extent.x, edge))) return 0;
  return std::min(std::uint32_t(room), cellsAlong(extent.x, cell / finestAlongX));
}

}  // namespace detail

/// Cells of edge `cell` over the bounds in a table of at most `table` (a power of two) cells: dense if need be with
/// longer edges, hashed where those would not do. No edge is shorter than 16 steps of the farthest coordinate, so that
/// cell numbers stay below 2²³ and a query's rounding within one more cell.
inline void layOut(PhotonGrid& grid, const Bounds& bounds, double cell, std::uint32_t table) {
  Vec3d const low = bounds.empty() ? Vec3d(0) : bounds.min, high = bounds.empty() ? Vec3d(0) : bounds.max;
  Vec3d const extent = high - low;
  double const farthest = double(std::max(maxAbs(Vec3(low)), maxAbs(Vec3(high))));
  cell = std::max({cell, 16 * double(machineEpsilon) * farthest, 1e-30});
  double edge = cell;
  std::uint32_t alongX = detail::denseAlongX(extent, cell, edge, table);
  while (alongX == 0 && edge < coarsestEdge * cell) {
    edge *= std::sqrt(2.0);
    alongX = detail::denseAlongX(extent, cell, edge, table);
  }
  grid.dense = alongX > 0;
  if (!grid.dense) edge = cell;
  bool const fitted = grid.dense && alongX < detail::cellsAlong(extent.x, cell / finestAlongX);
  double const edgeX = !grid.dense ? edge : fitted ? extent.x / alongX : cell / finestAlongX;
  double const edges[3] = {edgeX, edge, edge};
  double cells = 1;
  for (int a = 0; a < 3; ++a) {
    std::uint32_t const n = a == 0 && grid.dense ? alongX : detail::cellsAlong(extent[a], edges[a]);
    grid.size[a] = int(n);
    grid.edge[a] = Real(edges[a]);
    grid.inverseEdge[a] = Real(1 / edges[a]);
    grid.slack[a] = Real(16 * double(machineEpsilon) * (double(n) * edges[a] + farthest));
    cells *= double(n);
  }
  grid.origin = Vec3(low);
  grid.cells = grid.dense ? std::uint32_t(cells) : table;
}

}  // namespace ropelight::RL_TARGET
