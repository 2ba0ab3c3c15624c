#pragma once
// One hostile case: what makes it hard, what is measured, against what, and how near it must come.

#include <functional>
#include <string>
#include <vector>

#include "app/stress/cases/probe.h"

namespace ropelight {

/// One value of the quantity, for one parameter. noise: standard error of `value`, 0 where it is not random. bound: how
/// far from `expected` the truth may lie; the bound on the measurement is four standard errors more.
struct Measurement {
  std::string series;    ///< which mode, which part: "path", "sppm"
  double parameter = 0;  ///< of the sweep
  double value = 0, noise = 0;
  double expected = 0;
  double bound = 0;

  double error() const;  ///< |value − expected|
  /// Within the bound, and with noise below it, so that no case passes by being too noisy to fail.
  bool holds() const;
  /// "holds", "FAILS", "too noisy" or "not finite"
  const char* verdict() const;
};

enum class Holds : std::uint8_t { yes, no, leftOut };

struct CaseResult {
  std::string name, family;
  std::vector<Measurement> measurements;
  std::uint64_t nonFinite = 0;  ///< samples, over all renderings of the case
  std::string leftOut;          ///< why it was not run here; empty: it was
  double seconds = 0;

  Holds verdict() const;
  /// The measurement with the largest error by its bound; null where there is none.
  const Measurement* worst() const;
};

struct StressCase {
  const char* name;
  const char* hard;       ///< what makes it hard
  const char* parameter;  ///< what is swept, with its unit; "": nothing
  const char* quantity;   ///< what is measured
  const char* reference;  ///< against what
  const char* bound;      ///< where the bound comes from
  bool isShort;           ///< `--short` runs it
  std::function<std::vector<Measurement>(Probe&)> measure;
};

/// Cases of one kind. `name` is what the command line takes for all of them.
struct StressFamily {
  const char* name;
  const char* about;
  std::vector<StressCase> cases;
};

}  // namespace ropelight
