#include "app/bench.h"
#include "app/bench_result.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "app/output.h"
#include "render/core/error.h"
#include "render/core/version.h"
#include "render/film/atomic_file.h"
#include "render/scene/suggest.h"

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

/// Before minutes of measuring; makes the folder.
void checkOutputs(const BenchOptions& options, const std::vector<const Bench*>& chosen) {
  if (!options.json.empty() && options.json != "-") requireWritable(options.json);
  if (!options.csv.empty()) requireWritable(options.csv);
  if (options.out.empty()) return;
  std::error_code failure;
  std::filesystem::create_directories(options.out, failure);
  if (failure)
    throw Error(fmt::format("{}: cannot make the folder: {}; name another one", options.out, failure.message()));
  for (const Bench* bench : chosen) requireWritable(fileOf(options.out, bench->name, ".csv"));
}

void writeFiles(const std::string& folder, const BenchResult& result) {
  writeFile(fileOf(folder, result.bench, ".csv"), toCsv({result}));
  for (const BenchPlot& plot : result.plots)
    writeFile(fileOf(folder, result.bench + (plot.suffix.empty() ? "" : "-" + plot.suffix), ".svg"), toSvg(plot.plot));
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
  checkOutputs(options, chosen);

  std::vector<BenchResult> results;
  bool failed = false;
  for (const Bench* bench : chosen) {
    results.push_back(bench->run(options));
    failed = failed || results.back().failed();
    if (options.json != "-") fmt::print("{}", toText(results.back()));
    std::fflush(stdout);
    if (!options.out.empty()) writeFiles(options.out, results.back());
  }
  if (!options.json.empty()) writeJson(options.json, {{"version", version}, {"rows", toJson(results)}});
  if (!options.csv.empty()) writeFile(options.csv, toCsv(results));
  return int(failed ? ExitCode::checkFailed : ExitCode::done);
}

}  // namespace ropelight
