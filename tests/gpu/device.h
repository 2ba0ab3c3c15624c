#pragma once
// What tests that need a GPU ask first.

#include <doctest/doctest.h>

#include "render/integrators/integrator.h"

namespace ropelight {

inline const BackendChoice onCpu{BackendKind::cpu, 0, 0, false}, onGpu{BackendKind::cuda, 0, 0, false};

/// Says so where there is no usable CUDA device; the test then has nothing to do.
inline bool noGpu() {
  for (const DeviceInfo& d : listDevices())
    if (d.backend == BackendKind::cuda && d.usable) return false;
  MESSAGE("skipped: no usable CUDA device");
  return true;
}

}  // namespace ropelight
