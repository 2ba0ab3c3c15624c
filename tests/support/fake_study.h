#pragma once
// Studies whose curves are known exactly.

#include <cmath>
#include <functional>

#include "app/converge/analysis/study.h"

namespace ropelight {

/// Samples at 1/64, 1/32, … 2^(count − 7) seconds and 1, 2, 4, … iterations; its metrics are those of `error`, the
/// trimmed figure half of the whole.
inline StudyRun runOf(std::uint64_t seed, int count, const std::function<double(double)>& error) {
  StudyRun run{.seed = seed, .samples = {}};
  for (int i = 0; i < count; ++i) {
    ErrorSample sample{.seconds = std::ldexp(1.0, i - 6), .iterations = std::uint64_t(1) << i, .metrics = {}};
    sample.metrics.relMse = error(sample.seconds);
    sample.metrics.relMseTrimmed = sample.metrics.relMse / 2;
    sample.metrics.mse = sample.metrics.relMse / 10;
    sample.metrics.rmse = std::sqrt(sample.metrics.mse);
    run.samples.push_back(sample);
  }
  return run;
}

/// factor · seconds^exponent.
inline StudyRun powerRun(std::uint64_t seed, double factor, double exponent, int count = 11) {
  return runOf(seed, count, [=](double t) { return factor * std::pow(t, exponent); });
}

/// A run a factor, with seeds 1, 2, …
inline StudyMode powerMode(const std::string& label, const std::vector<double>& factors, double exponent) {
  StudyMode mode;
  mode.label = label;
  for (double const factor : factors) mode.runs.push_back(powerRun(mode.runs.size() + 1, factor, exponent));
  return mode;
}

}  // namespace ropelight
