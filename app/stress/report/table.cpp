#include <fmt/format.h>

#include <algorithm>

#include "app/run/progress.h"
#include "app/stress/report/report.h"

namespace ropelight {
namespace {

std::string line(const StressCase& c, const Measurement& m) {
  std::string const at = *c.parameter ? fmt::format(" at {:.4g} ({})", m.parameter, c.parameter) : "";
  return fmt::format("{}{}: {:.6g} +- {:.2g}, expected {:.6g} within {:.2g}", m.series, at, m.value, m.noise,
                     m.expected, m.bound);
}

}  // namespace

const char* verdictName(const CaseResult& result) {
  switch (result.verdict()) {
    case Holds::yes:
      return "holds";
    case Holds::no:
      return "FAILS";
    default:
      return "left out";
  }
}

std::string summary(const StressRun& run) {
  auto const count = [&](Holds verdict) {
    return std::count_if(run.results.begin(), run.results.end(), [&](const auto& r) { return r.verdict() == verdict; });
  };
  std::size_t const all = run.results.size();
  std::string text = count(Holds::no) > 0 ? fmt::format("FAILED: {} of {} cases do not hold", count(Holds::no), all)
                                          : fmt::format("{} of {} cases hold", count(Holds::yes), all);
  if (count(Holds::leftOut) > 0) text += fmt::format(", {} left out here", count(Holds::leftOut));
  if (run.interrupted) text += "; interrupted before the last";
  return text;
}

int printCatalogue(const std::vector<StressFamily>& families) {
  for (const StressFamily& family : families) {
    fmt::print("\n{}: {}\n", family.name, family.about);
    for (const StressCase& c : family.cases) {
      fmt::print("  {}{}\n    hard       {}\n", c.name, c.isShort ? " (short)" : "", c.hard);
      if (*c.parameter) fmt::print("    sweep      {}\n", c.parameter);
      fmt::print("    measured   {}\n    against    {}\n    bound      {}\n", c.quantity, c.reference, c.bound);
    }
  }
  return 0;
}

void printTable(const StressRun& run) {
  std::string family;
  for (const CaseResult& result : run.results) {
    if (result.family != family) fmt::print("\n{}\n", result.family);
    family = result.family;
    const StressCase& c = run.caseOf(result);
    const Measurement* const worst = result.worst();
    std::string const what = !result.leftOut.empty() ? result.leftOut : worst ? line(c, *worst) : "nothing measured";
    fmt::print("  {:<9}{:<22}{:>7}  {}\n", verdictName(result), result.name, formatDuration(result.seconds), what);
    if (result.verdict() != Holds::no) continue;
    if (result.nonFinite > 0) fmt::print("           {} samples were not finite\n", result.nonFinite);
    for (const Measurement& m : result.measurements) fmt::print("           {:<10} {}\n", m.verdict(), line(c, m));
  }
  fmt::print("\n{}, on {} ({}), seed {}, in {}\n", summary(run), run.device, run.backend, run.seed,
             formatDuration(run.seconds));
}

nlohmann::ordered_json toJson(const StressRun& run) {
  auto cases = nlohmann::ordered_json::array();
  for (const CaseResult& result : run.results) {
    const StressCase& c = run.caseOf(result);
    auto measurements = nlohmann::ordered_json::array();
    for (const Measurement& m : result.measurements)
      measurements.push_back({{"series", m.series},
                              {"parameter", m.parameter},
                              {"value", m.value},
                              {"noise", m.noise},
                              {"expected", m.expected},
                              {"bound", m.bound},
                              {"holds", m.holds()}});
    cases.push_back({{"family", result.family},
                     {"case", result.name},
                     {"hard", c.hard},
                     {"parameter", c.parameter},
                     {"quantity", c.quantity},
                     {"reference", c.reference},
                     {"bound", c.bound},
                     {"verdict", verdictName(result)},
                     {"left out", result.leftOut},
                     {"nonFinite", result.nonFinite},
                     {"seconds", result.seconds},
                     {"measurements", measurements}});
  }
  return {{"device", run.device},   {"backend", run.backend},  {"seed", run.seed}, {"short", run.isShort},
          {"seconds", run.seconds}, {"summary", summary(run)}, {"cases", cases}};
}

}  // namespace ropelight
