#pragma once
// `ropelight stress`: the catalogue of hostile cases, each measured against an answer that is known.

#include <cstdint>
#include <string>
#include <vector>

#include "app/stress/cases/run.h"
#include "app/stress/families/families.h"

namespace ropelight {

struct StressOptions {
  std::vector<std::string> names;  ///< of cases or families; empty: all
  BackendChoice backend;
  std::uint64_t seed = 1;
  bool isShort = false;  ///< the cases that the tests run, with fewer samples
  families::RayOptions rays;
  bool list = false;  ///< print the catalogue instead
  std::string json;   ///< file for the figures, "-" for standard output; empty: none
  std::string out;    ///< folder for stability.html and an SVG of every sweep; empty: none
};

/// Runs the cases one after the other; `begin` hears of each before it starts. Stops early, with what there is, where
/// the user interrupts.
StressRun runCases(std::vector<StressFamily> families, const StressOptions& options,
                   const std::function<void(const StressCase&)>& begin = {});

/// Returns the exit code: 6 where a case does not hold.
int runStress(const StressOptions& options);

}  // namespace ropelight
