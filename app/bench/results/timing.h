#pragma once
// Repeated runs, in turn.

#include <chrono>
#include <functional>
#include <span>
#include <vector>

namespace ropelight {

/// One of the things that are compared: a run returns its seconds.
struct Contender {
  std::function<double()> run;
  std::vector<double> seconds;  ///< of the timed runs
};

inline constexpr int warmUpRuns = 3;

/// Runs all contenders once, then again, so that a machine that slows down slows all alike: `warmUp` rounds untimed,
/// then `repeat` (≥ 1) rounds. Ends early, but not before one timed round, once a round would pass `limit` seconds of
/// measured time in all.
void timeInTurn(std::span<Contender> contenders, int warmUp, int repeat, double limit);

/// Seconds of wall clock that work() takes.
template <class Work>
double secondsOf(Work&& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ropelight
