#include "app/stress/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "app/run/interrupt.h"
#include "app/run/output.h"
#include "app/run/progress.h"
#include "app/stress/catalogue.h"
#include "app/stress/report/report.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Interrupted {};

CaseResult runCase(const StressFamily& family, const StressCase& c, const StressOptions& options,
                   const std::function<void()>& tick) {
  CaseResult result;
  result.name = c.name;
  result.family = family.name;
  Probe probe(options.backend, options.seed, options.isShort, tick);
  auto const start = Clock::now();
  try {
    result.measurements = c.measure(probe);
  } catch (const LeftOut& reason) {
    result.leftOut = reason.why;
  }
  result.nonFinite = probe.nonFinite();
  result.seconds = secondsSince(start);
  return result;
}

std::size_t countOf(const std::vector<StressFamily>& families) {
  std::size_t n = 0;
  for (const StressFamily& f : families) n += f.cases.size();
  return n;
}

/// Of the cases still to come, if they take as long as those before them did.
std::string timeLeft(std::size_t done, std::size_t all, double seconds) {
  return done == 0 ? "" : fmt::format(", about {} left", formatDuration(seconds / double(done) * double(all - done)));
}

}  // namespace

StressRun runCases(std::vector<StressFamily> families, const StressOptions& options,
                   const std::function<void(const StressCase&)>& begin) {
  StressRun run;
  run.seed = options.seed;
  run.isShort = options.isShort;
  run.families = std::move(families);
  StopOnSignal const stop;
  auto const tick = [&] {
    if (stop.requested()) throw Interrupted{};
  };
  auto const start = Clock::now();
  try {
    for (const StressFamily& family : run.families)
      for (const StressCase& c : family.cases) {
        if (begin) begin(c);
        run.results.push_back(runCase(family, c, options, tick));
      }
  } catch (const Interrupted&) {
    run.interrupted = true;
  }
  run.seconds = secondsSince(start);
  return run;
}

int runStress(const StressOptions& options) {
  if (options.list) return printCatalogue(stressCatalogue(options.rays));
  requireOutputs({options.json}, {options.rays.mesh});
  if (!options.out.empty()) makeFolder(options.out);
  std::vector<StressFamily> families = chooseCases(stressCatalogue(options.rays), options.names, options.isShort);
  ChosenBackend const chosen = chooseBackend(options.backend);
  std::size_t const all = countOf(families);
  std::size_t done = 0;
  auto const start = Clock::now();
  StressRun run = runCases(std::move(families), options, [&](const StressCase& c) {
    fmt::print(stderr, "[{}/{}] {}{}\n", done + 1, all, c.name, timeLeft(done, all, secondsSince(start)));
    ++done;
  });
  run.device = chosen.cuda ? deviceOf(chosen.gpu).name : cpuDevice(options.backend.threads).name;
  run.backend = nameOf(chosen.cuda ? BackendKind::cuda : BackendKind::cpu);
  if (options.json != "-") printTable(run);
  writeAll({[&] {
              if (!options.json.empty()) writeJson(options.json, toJson(run));
            },
            [&] {
              if (!options.out.empty()) writeReport(run, options.out);
            }});
  return int(run.failed() ? ExitCode::checkFailed : ExitCode::done);
}

}  // namespace ropelight
