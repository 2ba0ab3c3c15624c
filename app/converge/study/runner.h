#pragma once
// Runs the modes of a study on one scene, in turn, and looks at their error as they go.

#include <functional>
#include <string>
#include <vector>

#include "app/converge/study/reference.h"

namespace ropelight {

/// The limits of one run; zero: no such limit, but one of them is there.
struct RunLimits {
  double seconds = 0;  ///< wall clock of iterations
  std::uint64_t iterations = 0;
};

struct RunnerOptions {
  std::vector<ModeSpec> modes;
  RunLimits limits;
  int seeds = 1;  ///< runs of every mode, with the seeds s, s + 1, …
  BackendChoice backend;
  bool trimmed = false;
  ReferenceOptions reference;
  std::function<bool()> stop;                                              ///< asked now and then
  std::function<void(std::uint64_t iterations, double seconds)> progress;  ///< of all runs of the scene so far
};

/// Loads nothing: the scene is given. Iterations of the modes take turns, the least served first, so that a machine
/// that drifts treats them alike; one seed comes after the other. Throws Error as makeIntegrator and readReference do.
/// Stopped early, it holds what there was.
StudyScene runModes(const Scene& scene, const Settings& base, const RunnerOptions& options);

}  // namespace ropelight
