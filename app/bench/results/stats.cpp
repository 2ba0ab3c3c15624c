#include "app/bench/results/stats.h"

#include <fmt/format.h>

#include "app/arguments/values.h"
#include "app/run/report.h"

namespace ropelight {
namespace {

double perIteration(const Stats& stats, double count) {
  return stats.iterations > 0 ? count / double(stats.iterations) : 0;
}

/// "mode=sppm radius=0.03 …".
std::string settingsText(Settings settings) {
  std::string text;
  settings.params([&](const char* name, const auto& value, const ParamInfo&) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, formatValue(value));
  });
  return text;
}

}  // namespace

BenchRow statsRow(const std::string& timed, const std::string& scene, const Stats& stats, std::vector<double> seconds) {
  BenchRow row;
  row.series = fmt::format("{}, {}", scene, timed);
  row.place = stats.firstRadius;
  row.x = fmt::format("{:.4g}", stats.firstRadius);
  row.seconds = std::move(seconds);
  row.value = megaRays(stats);
  row.unit = "Mrays/s";
  row.settings = settingsText(stats.settings);
  row.note = fmt::format("{:.4g} Mphotons/s, {:.0f} photons stored an iteration", megaPhotons(stats),
                         perIteration(stats, double(stats.photonsStored)));
  row.details = {{"timed", timed},
                 {"scene", scene},
                 {"megaRays", megaRays(stats)},
                 {"megaPhotons", megaPhotons(stats)},
                 {"settings", toJson(stats.settings)},
                 {"stats", toJson(stats)}};
  return row;
}

std::string stagesText(const Stats& stats) {
  std::string text;
  for (const auto& [stage, seconds] : stats.stageSeconds)
    text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", stage, perIteration(stats, seconds) * 1e3);
  return text;
}

}  // namespace ropelight
