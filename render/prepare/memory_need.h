#pragma once
// What an integrator will take, told before anything is allocated.

#include <cstdint>
#include <map>
#include <string>

#include "render/prepare/prepare.h"

namespace ropelight {

/// Bytes by purpose, as the ledger names them: film, gather points, photons, photon paths and grid. Photons count as
/// they are planned at first; scenes that store more of them make them grow within their budget. What the scene itself
/// takes is not in it. deviceMemory: bytes that a quarter of is the photons' budget.
std::map<std::string, std::uint64_t> memoryNeed(const Settings& resolved, FeatureBits features,
                                                std::uint64_t deviceMemory);

/// Bytes of the film on the host, as Integrator::film() returns it.
std::uint64_t imageBytes(const Settings& resolved);

/// Throws Error (outOfMemory), with the bytes needed and free, where integrators of these settings cannot fit into the
/// host's memory or, on a GPU, into the device's. before: what the new one takes the place of; null: nothing.
void requireMemory(const Prepared& prepared, const Prepared* before = nullptr);

}  // namespace ropelight
