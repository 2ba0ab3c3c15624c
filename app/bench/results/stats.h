#pragma once
// A benchmark's row, made from an integrator's statistics.

#include "app/bench/results/result.h"
#include "render/integrators/integrator.h"

namespace ropelight {

/// What was timed of which scene; x is the first radius. `stats`: of the timed runs alone.
BenchRow statsRow(const std::string& timed, const std::string& scene, const Stats& stats, std::vector<double> seconds);

/// "TracePhotons 1.2, …": milliseconds per iteration by stage; empty where none were timed.
std::string stagesText(const Stats& stats);

}  // namespace ropelight
