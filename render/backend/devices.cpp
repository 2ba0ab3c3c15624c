#include "render/backend/devices.h"

#include <fmt/format.h>
#include <oneapi/tbb/info.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "render/backend/available_memory.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "CPU";
}

}  // namespace

DeviceInfo cpuDevice(int threads) {
  static const std::string name = processorName();
  static const std::uint64_t groupLimit = groupMemoryLimit();
  DeviceInfo d;
  d.backend = BackendKind::cpu;
  int const used = threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
  d.name = fmt::format("{}, {} thread{}", name, used, used == 1 ? "" : "s");
  d.memory = std::min(std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGESIZE)), groupLimit);
  d.usable = true;
  return d;
}

#if !ROPELIGHT_CUDA
std::vector<DeviceInfo> cudaDevices() { return {}; }
std::uint64_t freeDeviceMemory(int) { return unknownMemory; }
#endif

DeviceInfo deviceOf(int gpu) {
  for (const DeviceInfo& d : cudaDevices())
    if (d.index == gpu) return d;
  return {};
}

std::vector<DeviceInfo> listDevices() {
  std::vector<DeviceInfo> all{cpuDevice(0)};
  for (const DeviceInfo& d : cudaDevices()) all.push_back(d);
  return all;
}

ChosenBackend chooseBackend(const BackendChoice& choice) {
  if (choice.backend == BackendKind::cpu) return {false, false, 0, "CPU, as asked for"};
  if (choice.backend == BackendKind::cpu64) return {false, true, 0, "CPU in double precision, as asked for"};
  std::vector<DeviceInfo> const gpus = cudaDevices();
  std::string problem = "this build has no CUDA; configure with a CUDA toolkit of version 12 or newer";
  if (ROPELIGHT_CUDA) problem = "no NVIDIA GPU was found";
  for (const DeviceInfo& d : gpus) {
    bool const wanted = choice.gpu < 0 || d.index == choice.gpu;
    if (d.usable && wanted) return {true, false, d.index, fmt::format("GPU {}: {}", d.index, d.name)};
    if (!d.usable && wanted) problem = d.note;
  }
  if (!gpus.empty() && gpus.front().usable && choice.gpu >= int(gpus.size()))
    problem = fmt::format("--gpu {}: there are {} GPUs, numbered from 0", choice.gpu, gpus.size());
  if (choice.backend == BackendKind::cuda) throw Error(fmt::format("--backend cuda: {}", problem), ExitCode::noDevice);
  return {false, false, 0, fmt::format("CPU: {}", problem)};
}

}  // namespace ropelight
