#pragma once
// Which devices there are and which one is taken.

#include <cstdint>
#include <string>
#include <vector>

#include "render/choices/choice.h"

namespace ropelight {

/// What computes.
enum class BackendKind : std::uint8_t { automatic, cuda, cpu, cpu64 };

template <>
struct ChoicesOf<BackendKind> {
  static constexpr Choice<BackendKind> table[] = {
      {BackendKind::automatic, "auto", "the first usable GPU, else the CPU"},
      {BackendKind::cuda, "cuda", "an NVIDIA GPU"},
      {BackendKind::cpu, "cpu", "the CPU"},
      {BackendKind::cpu64, "cpu64", "the CPU in double precision, slower: to tell errors of floats from noise"},
  };
};

/// A usable device, or why it cannot be used.
struct DeviceInfo {
  BackendKind backend = BackendKind::cpu;  ///< cpu or cuda
  int index = 0;                           ///< of the GPU; 0 for the CPU
  std::string name;
  std::uint64_t memory = 0;  ///< bytes
  bool usable = false;
  std::string note;  ///< driver and runtime versions, or why it is not usable
};

/// The CPU first, then every GPU that the driver names. Never throws for a missing driver or device.
std::vector<DeviceInfo> listDevices();

struct BackendChoice {
  BackendKind backend = BackendKind::automatic;
  int gpu = -1;             ///< index; −1: the first usable one
  int threads = 0;          ///< CPU threads; 0: all cores
  bool stageTimes = false;  ///< time every stage on a GPU too, at the cost of a synchronisation each
};

DeviceInfo cpuDevice(int threads);
/// Empty where the program was built without CUDA; one unusable entry where the driver is missing or too old.
std::vector<DeviceInfo> cudaDevices();
/// The GPU of that index; a DeviceInfo without memory where there is none.
DeviceInfo deviceOf(int gpu);
/// Bytes that the GPU has free; unknownMemory where it does not say.
std::uint64_t freeDeviceMemory(int gpu);

struct ChosenBackend {
  bool cuda = false;
  bool inDouble = false;  ///< on the CPU
  int gpu = 0;
  std::string why;  ///< one sentence: what was taken and why
};

/// Throws Error (noDevice) where the one asked for cannot be used.
ChosenBackend chooseBackend(const BackendChoice& choice);

}  // namespace ropelight
