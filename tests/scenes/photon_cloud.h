#pragma once
// Photons in a grid for tests, laid out as the integrator lays them out.

#include <algorithm>
#include <numeric>
#include <vector>

#include "accel/photon_grid/grid_layout.h"

namespace ropelight {

/// Photons sorted into a grid over `bounds`, the grid's arrays, and which photon went where.
struct PhotonCloud {
  cpu::PhotonGrid grid;
  std::vector<cpu::PhotonPosition> positions;  ///< in the grid's order
  std::vector<cpu::PhotonPower> powers;
  std::vector<std::uint32_t> starts;

  PhotonCloud(std::vector<cpu::PhotonPosition> p, std::vector<cpu::PhotonPower> w, const Bounds& bounds, double cell,
              std::uint32_t table)
      : positions(std::move(p)), powers(std::move(w)) {
    cpu::layOut(grid, bounds, cell, table);
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    auto const key = [&](std::uint32_t i) { return grid.key(positions[i].p); };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<cpu::PhotonPosition> sortedPositions;
    std::vector<cpu::PhotonPower> sortedPowers;
    starts.assign(std::size_t(grid.cells) + 1, 0);
    for (std::uint32_t i : order) {
      sortedPositions.push_back(positions[i]);
      sortedPowers.push_back(powers[i]);
      ++starts.at(key(i) + 1);
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    positions.swap(sortedPositions);
    powers.swap(sortedPowers);
    std::uint32_t const n = std::uint32_t(positions.size());
    grid.starts = {starts.data(), std::uint32_t(starts.size())};
    grid.positions = {positions.data(), n};
    grid.powers = {powers.data(), n};
  }
  PhotonCloud(const PhotonCloud&) = delete;
};

}  // namespace ropelight
