#include "app/viewer/session/stage_history.h"

#include <algorithm>
#include <cmath>

namespace ropelight::view {
namespace {

bool isTime(double seconds) { return seconds >= 0 && std::isfinite(seconds); }

}  // namespace

std::vector<StageSummary> summarizeStages(const std::deque<StageSample>& history) {
  std::vector<StageSummary> stages;
  std::vector<double> counts;
  for (const StageSample& sample : history)
    for (auto const& [name, seconds] : sample) {
      if (!isTime(seconds)) continue;
      double const ms = seconds * 1e3;
      auto stage = std::find_if(stages.begin(), stages.end(), [&, n = &name](auto const& s) { return s.name == *n; });
      if (stage == stages.end()) {
        stage = stages.insert(stages.end(), {name, ms, 0, ms});
        counts.push_back(0);
      }
      double& count = counts[std::size_t(stage - stages.begin())];
      stage->least = std::min(stage->least, ms);
      stage->most = std::max(stage->most, ms);
      stage->mean += (ms - stage->mean) / ++count;
    }
  return stages;
}

double longestSample(const std::deque<StageSample>& history) {
  double longest = 0;
  for (const StageSample& sample : history) {
    double sum = 0;
    for (auto const& [name, seconds] : sample) sum += isTime(seconds) ? seconds * 1e3 : 0;
    longest = std::max(longest, sum);
  }
  return longest;
}

}  // namespace ropelight::view
