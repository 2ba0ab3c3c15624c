#include "app/commands/devices.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/output.h"
#include "app/run/report.h"
#include "render/core/error.h"
#include "render/integrators/integrator.h"

namespace ropelight {
namespace {

void printTable(const std::vector<DeviceInfo>& devices) {
  std::size_t width = 4;
  for (const DeviceInfo& d : devices) width = std::max(width, d.name.size());
  fmt::print("{:<9}{:<5}{:<{}}  {:>10}  {:<8}{}\n", "backend", "gpu", "name", width, "memory", "usable", "note");
  for (const DeviceInfo& d : devices) {
    std::string const gpu = d.backend == BackendKind::cpu ? "-" : fmt::format("{}", d.index);
    std::string const memory = d.memory > 0 ? formatBytes(d.memory) : "-";
    fmt::print("{:<9}{:<5}{:<{}}  {:>10}  {:<8}{}\n", nameOf(d.backend), gpu, d.name, width, memory,
               d.usable ? "yes" : "no", d.note);
  }
}

nlohmann::ordered_json toJson(const std::vector<DeviceInfo>& devices) {
  auto json = nlohmann::ordered_json::array();
  for (const DeviceInfo& d : devices)
    json.push_back({{"backend", nameOf(d.backend)},
                    {"index", d.index},
                    {"name", d.name},
                    {"memory", d.memory},
                    {"usable", d.usable},
                    {"note", d.note}});
  return {{"devices", json}};
}

}  // namespace

int runDevices(const DevicesOptions& options) {
  requireOutputs({options.json}, {});
  std::vector<DeviceInfo> const devices = listDevices();
  if (options.json != "-") printTable(devices);
  if (!options.json.empty()) writeJson(options.json, toJson(devices));
  return int(ExitCode::done);
}

}  // namespace ropelight
