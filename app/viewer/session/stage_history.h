#pragma once
// The stages' times over the latest batches, summed up. No window.

#include <string>
#include <vector>

#include "app/viewer/session/renderer.h"

namespace ropelight::view {

/// Milliseconds; a stage counts only in batches that had it.
struct StageSummary {
  std::string name;
  double least = 0, mean = 0, most = 0;
};

/// In order of first appearance. Times that are negative or not finite are left out.
std::vector<StageSummary> summarizeStages(const std::deque<StageSample>& history);

/// The largest sum of one sample's stages, milliseconds.
double longestSample(const std::deque<StageSample>& history);

}  // namespace ropelight::view
