#include "app/bench/bench.h"
#include "app/bench/results/result.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/arguments/scene_path.h"
#include "app/run/output.h"
#include "app/run/standard_streams.h"
#include "app/run/version.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/import/load.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

const Bench& findBench(const std::string& name, std::span<const Bench> table) {
  for (const Bench& bench : table)
    if (name == bench.name) return bench;
  throw Error(fmt::format("bench: there is no benchmark '{}'; there are: {}", name, joinNames(benchNames(table))),
              ExitCode::usage);
}

std::vector<const Bench*> chosenOf(const BenchOptions& options, std::span<const Bench> table) {
  std::vector<const Bench*> chosen;
  for (const std::string& name : options.names) chosen.push_back(&findBench(name, table));
  for (const Bench& bench : table)
    if (options.names.empty() && !bench.needsWindow) chosen.push_back(&bench);
  return chosen;
}

std::string fileOf(const std::string& folder, const std::string& name, const char* extension) {
  return (std::filesystem::path(folder) / (name + extension)).string();
}

std::vector<std::string> inputsOf(const BenchOptions& options) {
  std::vector<std::string> inputs{options.mesh};
  if (options.scene.scene.empty()) return inputs;
  for (const std::string& file : filesOf(loadScene(findScene(options.scene.scene)))) inputs.push_back(file);
  return inputs;
}

/// Before minutes of measuring; makes the folder.
void checkOutputs(const BenchOptions& options, const std::vector<const Bench*>& chosen,
                  const std::vector<std::string>& inputs) {
  std::vector<std::string> outputs{options.json, options.csv};
  if (!options.out.empty()) {
    makeFolder(options.out);
    for (const Bench* bench : chosen)
      for (const char* extension : {".csv", ".svg"}) outputs.push_back(fileOf(options.out, bench->name, extension));
  }
  requireOutputs(outputs, inputs);
}

/// inputs: a plot's name is known only now.
void writeFiles(const std::string& folder, const BenchResult& result, const std::vector<std::string>& inputs) {
  writeFile(fileOf(folder, result.bench, ".csv"), toCsv({result}));
  for (const BenchPlot& plot : result.plots) {
    std::string const file = fileOf(folder, result.bench + (plot.suffix.empty() ? "" : "-" + plot.suffix), ".svg");
    requireNoInput(file, inputs);
    writeFile(file, toSvg(plot.plot));
  }
}

}  // namespace

std::span<const Bench> benches() {
#define RL_BENCH(function, name, needsWindow) {name, function, needsWindow},
  static constexpr Bench table[] = {RL_BENCHES(RL_BENCH)};
#undef RL_BENCH
  return table;
}

std::vector<std::string> benchNames(std::span<const Bench> table) {
  std::vector<std::string> names;
  for (const Bench& bench : table) names.push_back(bench.name);
  return names;
}

int runBench(const BenchOptions& options, std::span<const Bench> table) {
  std::vector<const Bench*> const chosen = chosenOf(options, table);
  std::vector<std::string> const inputs = inputsOf(options);
  checkOutputs(options, chosen, inputs);

  std::vector<BenchResult> results;
  bool failed = false;
  for (const Bench* bench : chosen) {
    results.push_back(bench->run(options));
    failed = failed || results.back().failed();
    if (options.json != "-") fmt::print("{}", toText(results.back()));
    flushStandardOutput();
    if (!options.out.empty()) writeAll({[&] { writeFiles(options.out, results.back(), inputs); }});
  }
  writeAll({[&] {
              if (!options.json.empty()) writeJson(options.json, {{"version", version}, {"rows", toJson(results)}});
            },
            [&] {
              if (!options.csv.empty()) writeFile(options.csv, toCsv(results));
            }});
  return int(failed ? ExitCode::checkFailed : ExitCode::done);
}

}  // namespace ropelight
