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

struct Bench {
  const char* name;
  BenchResult (*run)(const BenchOptions&);
  bool needsWindow;
};

/// A new benchmark is its own file and one line here.
constexpr Bench benches[] = {{"iteration", benchIteration, false}, {"gather", benchGather, false},
                             {"kdtree", benchKdTree, false},       {"split", benchSplit, false},
                             {"modes", benchModes, false},         {"traversal", benchTraversal, false},
                             {"display", benchDisplay, true}};

const Bench& findBench(const std::string& name) {
  for (const Bench& bench : benches)
    if (name == bench.name) return bench;
  throw Error(fmt::format("bench: there is no benchmark '{}'; there are: {}", name, joinNames(benchNames())),
              ExitCode::usage);
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
