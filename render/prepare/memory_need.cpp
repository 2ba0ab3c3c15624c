#include "render/prepare/memory_need.h"

#include <fmt/format.h>

#include <tuple>

#include "render/backend/available_memory.h"
#include "render/backend/cpu_backend.h"
#include "render/backend/devices.h"
#include "render/core/bytes.h"
#include "render/core/error.h"
#include "render/film/image.h"
#include "render/kernels/gather_adaptive.h"
#include "render/kernels/trace_camera.h"
#include "render/photons/photon_plan.h"

namespace ropelight {
namespace {

using Need = std::map<std::string, std::uint64_t>;

std::uint64_t total(const Need& need) {
  std::uint64_t sum = 0;
  for (const auto& [purpose, bytes] : need) sum += bytes;
  return sum;
}

std::uint64_t slotsOf(const Settings& s) {
  cpu::FrameView frame;
  frame.width = s.width;
  frame.height = s.height;
  return frame.slots();
}

Need needOf(const Prepared& p) {
  DeviceInfo const device = p.onGpu ? deviceOf(p.backend.gpu) : cpuDevice(p.backend.threads);
  return memoryNeed(p.settings, p.features, device.memory);
}

[[noreturn]] void refuse(const Prepared& p, const Need& need, const std::string& place, std::uint64_t free) {
  std::string parts;
  for (const auto& [purpose, bytes] : need)
    if (bytes >= total(need) / 100)
      parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", purpose, formatBytes(bytes));
  bool const photons = (p.features & feature::photons) != 0;
  throw Error(fmt::format("{} x {} pixels{} need {} of {} memory ({}), and {} are free; lower --width, --height{}",
                          p.settings.width, p.settings.height,
                          photons ? fmt::format(" and {} photons", p.settings.photons) : "", formatBytes(total(need)),
                          place, parts, formatBytes(free), photons ? ", --photons or --photon-memory" : ""),
              ExitCode::outOfMemory);
}

void requireFit(const Prepared& p, const Need& need, const std::string& place, std::uint64_t free, std::uint64_t held) {
  if (free == unknownMemory || total(need) <= free + held) return;
  refuse(p, need, place, free + held);
}

void addMap(const cpu::PhotonPlan& plan, Need& need) {
  std::uint64_t const stored = plan.photonCapacity;
  need["photons"] +=
      plan.slots() * sizeof(cpu::Photon) + stored * (sizeof(cpu::PhotonPosition) + sizeof(cpu::PhotonPower));
  need["photon paths"] +=
      plan.paths * (2 * sizeof(cpu::DepositCount) + sizeof(std::uint32_t)) + sizeof(cpu::DepositCount);
  need["grid"] += (4 * stored + plan.tableSize + 1) * sizeof(std::uint32_t);
}

bool sameNeed(const Prepared& a, const Prepared& b) {
  auto const key = [](const Prepared& p) {
    const Settings& s = p.settings;
    return std::tuple(s.width, s.height, s.photons, s.causticShare, s.photonMemory,
                      p.features & (feature::photons | feature::caustics));
  };
  return key(a) == key(b);
}

}  // namespace

std::map<std::string, std::uint64_t> memoryNeed(const Settings& s, FeatureBits features, std::uint64_t deviceMemory) {
  std::uint64_t const slots = slotsOf(s);
  Need need;
  need["film"] = slots * (sizeof(Rgb) + sizeof(glm::dvec3) + sizeof(std::uint32_t)) + sizeof(cpu::IterationState);
  if (!(features & feature::photons)) return need;
  need["gather points"] = slots * sizeof(cpu::GatherPoint);
  std::uint64_t const budget = s.photonMemory > 0 ? s.photonMemory << 20 : deviceMemory / 4;
  bool const apart = (features & feature::caustics) != 0;
  std::uint64_t const forCaustics = apart ? cpu::causticBudget(budget) : 0;
  addMap(cpu::planPhotons(apart ? s.otherPaths() : s.photons, budget - forCaustics, cpu::expectedPerPath,
                          cpu::expectedTail),
         need);
  if (apart) need["gather points"] += slots * sizeof(cpu::DiscState);
  if (apart) addMap(cpu::planCaustics(s.causticPaths(), forCaustics), need);
  return need;
}

std::uint64_t imageBytes(const Settings& s) { return std::uint64_t(s.width) * std::uint64_t(s.height) * sizeof(Rgb); }

void requireMemory(const Prepared& p, const Prepared* before) {
  if (before && sameNeed(p, *before)) return;  // a camera that moves must not wait for the system's answers
  Need need = needOf(p);
  std::uint64_t held = before ? total(needOf(*before)) : 0;
  if (p.onGpu) {
    requireFit(p, need, "the GPU's", freeDeviceMemory(p.backend.gpu), held);
    need.clear();
    held = 0;
  }
  need["image"] = imageBytes(p.settings);
  requireFit(p, need, "the machine's", availableMemory(), held);
}

}  // namespace ropelight
