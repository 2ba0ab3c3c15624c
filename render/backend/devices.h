#pragma once
// Which devices there are and which one is taken.

#include <string>
#include <vector>

#include "render/integrators/integrator.h"

namespace ropelight {

DeviceInfo cpuDevice(int threads);
/// Empty where the program was built without CUDA; one unusable entry where the driver is missing or too old.
std::vector<DeviceInfo> cudaDevices();
/// The GPU of that index; a DeviceInfo without memory where there is none.
DeviceInfo deviceOf(int gpu);
/// Bytes that the GPU has free; unknownMemory where it does not say.
std::uint64_t freeDeviceMemory(int gpu);

struct ChosenBackend {
  bool cuda = false;
  int gpu = 0;
  std::string why;  ///< one sentence: what was taken and why
};

/// Throws Error (noDevice) where the one asked for cannot be used, usage where its name is unknown.
ChosenBackend chooseBackend(const BackendChoice& choice);

}  // namespace ropelight
