#include <cuda_runtime.h>
#include <fmt/format.h>

#include "render/backend/available_memory.h"
#include "render/backend/devices.h"

namespace ropelight {
namespace {

std::string versionText(int v) { return v == 0 ? "none" : fmt::format("{}.{}", v / 1000, v % 1000 / 10); }

DeviceInfo describe(int index, int driver, int runtime) {
  DeviceInfo d;
  d.backend = BackendKind::cuda;
  d.index = index;
  cudaDeviceProp p{};
  if (cudaError_t const code = cudaGetDeviceProperties(&p, index); code != cudaSuccess) {
    d.note = fmt::format("GPU {}: {}", index, cudaGetErrorString(code));
    return d;
  }
  d.name = p.name;
  d.memory = p.totalGlobalMem;
  d.usable = p.major * 10 + p.minor >= 75;
  d.note = fmt::format("compute capability {}.{}, driver for CUDA {}, runtime {}", p.major, p.minor,
                       versionText(driver), versionText(runtime));
  if (!d.usable) d.note += "; 7.5 or newer is needed";
  return d;
}

}  // namespace

std::uint64_t freeDeviceMemory(int gpu) {
  std::size_t free = 0, all = 0;
  if (cudaSetDevice(gpu) == cudaSuccess && cudaMemGetInfo(&free, &all) == cudaSuccess) return free;
  cudaGetLastError();
  return unknownMemory;
}

std::vector<DeviceInfo> cudaDevices() {
  int driver = 0, runtime = 0, count = 0;
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  cudaError_t const code = cudaGetDeviceCount(&count);
  if (code == cudaErrorNoDevice || (code == cudaErrorInsufficientDriver && driver == 0)) return {};
  if (code != cudaSuccess) {
    DeviceInfo d;
    d.backend = BackendKind::cuda;
    d.name = "NVIDIA GPU";
    d.note = fmt::format("{}: the driver is for CUDA {}, this program needs {}{}", cudaGetErrorString(code),
                         versionText(driver), versionText(runtime),
                         code == cudaErrorInsufficientDriver ? "; install a newer driver" : "");
    return {d};
  }
  std::vector<DeviceInfo> devices;
  for (int i = 0; i < count; ++i) devices.push_back(describe(i, driver, runtime));
  return devices;
}

}  // namespace ropelight
