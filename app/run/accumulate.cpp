#include "app/run/accumulate.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

namespace ropelight {
namespace {

constexpr double batchSeconds = 0.1;
constexpr std::uint64_t maxBatch = 4096;

/// Iterations for the next batch, from what the latest took. Grows at most twofold, since the first are slow.
std::uint64_t nextBatch(std::uint64_t latest, double latestSeconds, double secondsLeft) {
  double const wanted = std::min(batchSeconds, secondsLeft);
  double const fitting = latestSeconds > 0 ? wanted / latestSeconds * double(latest) : double(maxBatch);
  double const limit = double(std::min(2 * latest, maxBatch));
  return std::uint64_t(std::clamp(fitting, 1.0, limit));
}

}  // namespace

Accumulated accumulate(Integrator& integrator, const Goal& goal, const StopOnSignal& stop, bool quiet) {
  using Clock = std::chrono::steady_clock;
  Progress progress(goal, quiet);
  Clock::time_point const start = Clock::now();
  auto const elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  double const timeLimit = goal.seconds > 0 ? goal.seconds : std::numeric_limits<double>::infinity();
  std::uint64_t const limit = goal.iterations > 0 ? goal.iterations : std::numeric_limits<std::uint64_t>::max();

  std::uint64_t done = 0;
  std::uint64_t batch = 1;
  double now = 0;
  do {
    batch = std::min(batch, limit - done);
    double const before = now;
    if (!integrator.advance(int(batch))) return {elapsed(), true};
    now = elapsed();
    done += batch;
    progress.update(done, now);
    batch = nextBatch(batch, now - before, timeLimit - now);
  } while (done < limit && now < timeLimit && !stop.requested());
  return {now, stop.requested() && done < limit};
}

}  // namespace ropelight
