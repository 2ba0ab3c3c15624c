#include "app/bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/output.h"
#include "app/report.h"
#include "app/values.h"
#include "render/core/error.h"
#include "render/core/version.h"
#include "render/film/atomic_file.h"
#include "render/scene/suggest.h"

namespace ropelight {
namespace {

struct Bench {
  const char* name;
  std::vector<BenchRow> (*run)(const BenchOptions&);
  bool needsWindow;
};

/// A new benchmark is its own file and one line here.
constexpr Bench benches[] = {{"iteration", benchIteration, false}, {"display", benchDisplay, true}};

struct Summary {
  double median, min, max;
};

/// Of at least one value.
Summary summarise(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  std::size_t const n = seconds.size();
  return {(seconds[(n - 1) / 2] + seconds[n / 2]) / 2, seconds.front(), seconds.back()};
}

double perIteration(const Stats& stats, double count) {
  return stats.iterations > 0 ? count / double(stats.iterations) : 0;
}

std::string threadsText(const BenchRow& row) { return row.threads > 0 ? fmt::format("{}", row.threads) : "all"; }

void printRow(const BenchRow& row) {
  Summary const s = summarise(row.seconds);
  fmt::print("\n{}: {} on {}, {} threads\n", row.bench, row.scene, row.stats.device, threadsText(row));
  Settings settings = row.settings;
  settings.params([separator = "  "](const char* name, const auto& value, const ParamInfo&) mutable {
    fmt::print("{}{}={}", separator, name, formatValue(value));
    separator = " ";
  });
  fmt::print("\n  {:<18}{:.4g} s median, {:.4g} min, {:.4g} max of {}\n", row.timed, s.median, s.min, s.max,
             row.seconds.size());
  fmt::print("  {:<18}{:.4g} Mrays/s, {:.4g} Mphotons/s\n", "rates", megaRays(row.stats), megaPhotons(row.stats));
  fmt::print("  {:<18}{:.0f} an iteration\n", "photons stored",
             perIteration(row.stats, double(row.stats.photonsStored)));
  for (const auto& [stage, seconds] : row.stats.stageSeconds)
    fmt::print("  {:<18}{:.4g} s an iteration\n", stage, perIteration(row.stats, seconds));
}

nlohmann::ordered_json toJson(const BenchRow& row) {
  Summary const s = summarise(row.seconds);
  return {{"bench", row.bench},
          {"timed", row.timed},
          {"scene", row.scene},
          {"threads", row.threads},
          {"median", s.median},
          {"min", s.min},
          {"max", s.max},
          {"seconds", row.seconds},
          {"megaRays", megaRays(row.stats)},
          {"megaPhotons", megaPhotons(row.stats)},
          {"settings", toJson(row.settings)},
          {"stats", toJson(row.stats)}};
}

/// A text cell, quoted as RFC 4180 has it.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (char const c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

std::string toCsv(const std::vector<BenchRow>& rows) {
  std::string csv =
      "bench,scene,device,threads,width,height,photons,radius,accel,seed,repeat,median_s,min_s,max_s,mrays_s,"
      "mphotons_s,stored_per_iteration\n";
  for (const BenchRow& row : rows) {
    Summary const s = summarise(row.seconds);
    const Settings& set = row.settings;
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.bench, quoted(row.scene),
                       quoted(row.stats.device), row.threads, set.width, set.height, set.photons, set.radius, set.accel,
                       set.seed, row.seconds.size(), s.median, s.min, s.max, megaRays(row.stats),
                       megaPhotons(row.stats), perIteration(row.stats, double(row.stats.photonsStored)));
  }
  return csv;
}

const Bench& findBench(const std::string& name) {
  for (const Bench& bench : benches)
    if (name == bench.name) return bench;
  throw Error(fmt::format("bench: there is no benchmark '{}'; there are: {}", name, joinNames(benchNames())),
              ExitCode::usage);
}

}  // namespace

std::vector<std::string> benchNames() {
  std::vector<std::string> names;
  for (const Bench& bench : benches) names.push_back(bench.name);
  return names;
}

int runBench(const BenchOptions& options) {
  std::vector<const Bench*> chosen;
  for (const std::string& name : options.names) chosen.push_back(&findBench(name));
  for (const Bench& bench : benches)
    if (options.names.empty() && !bench.needsWindow) chosen.push_back(&bench);
  if (!options.json.empty() && options.json != "-") requireWritable(options.json);
  if (!options.csv.empty()) requireWritable(options.csv);

  std::vector<BenchRow> rows;
  for (const Bench* bench : chosen) {
    for (const BenchRow& row : bench->run(options)) {
      if (options.json != "-") printRow(row);
      rows.push_back(row);
    }
  }
  auto json = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) json.push_back(toJson(row));
  if (!options.json.empty()) writeJson(options.json, {{"version", version}, {"rows", json}});
  if (!options.csv.empty()) writeFile(options.csv, toCsv(rows));
  return int(ExitCode::done);
}

}  // namespace ropelight
