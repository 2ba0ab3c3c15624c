#pragma once
// The arithmetic of log-log plots: axes, ticks, which curve is lower. No window.

#include <string>
#include <vector>

#include "app/plot/curve_math.h"

namespace ropelight::view {

using ropelight::fitLastDecade;
using ropelight::interpolateLog;
using ropelight::isPlottable;
using ropelight::PlotPoint;
using ropelight::plottable;
using ropelight::PowerLaw;

/// Of a logarithmic axis: 0 < low < high.
struct LogRange {
  double low = 0.1, high = 10;
};

/// Spans the values that are positive and finite, with `margin` of the span added at both ends; at least a factor of 3
/// wide, and the default where there are no such values.
LogRange logRange(const std::vector<double>& values, double margin = 0.05);

/// 0 at low, 1 at high; values outside lie outside.
double logPosition(LogRange range, double value);
double logValue(LogRange range, double position);

struct AxisTick {
  double value = 0;
  std::string label;  ///< empty for the thin lines between
};

/// Powers of ten with labels, thinned to at most `mostLabels`; 2 to 9 times them without, where decades are not
/// thinned. Where fewer than two powers of ten lie inside, 2 and 5 times them have labels too.
std::vector<AxisTick> logTicks(LogRange range, int mostLabels);

/// Which of two error curves (seconds, error) is lower at the largest time that both have reached, as one sentence.
/// Below 2% of difference neither is called closer.
std::string closerSentence(const std::vector<PlotPoint>& a, const std::vector<PlotPoint>& b);

}  // namespace ropelight::view
