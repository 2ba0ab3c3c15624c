#include "render/backend/cpu_backend.h"

#include "render/backend/devices.h"

namespace ropelight::RL_TARGET {

DeviceInfo Backend::device() const { return cpuDevice(threads()); }

}  // namespace ropelight::RL_TARGET
