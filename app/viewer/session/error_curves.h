#pragma once
// The errors of an estimate as points of a plot.

#include <vector>

#include "app/plot/plot_math.h"
#include "app/viewer/session/renderer.h"

namespace ropelight::view {

inline std::vector<PlotPoint> errorCurve(const EstimateStatus& status) {
  std::vector<PlotPoint> points;
  for (const ErrorPoint& error : status.errors) points.push_back({error.seconds, error.relMse});
  return points;
}

}  // namespace ropelight::view
