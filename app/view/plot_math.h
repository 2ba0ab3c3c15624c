#pragma once
// The arithmetic of log-log plots: axes, ticks, power laws, interpolation. No window.

#include <optional>
#include <string>
#include <vector>

namespace ropelight::view {

struct PlotPoint {
  double x = 0, y = 0;
};

/// Both coordinates are positive and finite, so that they have a place on logarithmic axes.
bool isPlottable(PlotPoint p);
std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points);

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

/// y = factor · x^exponent.
struct PowerLaw {
  double factor = 0, exponent = 0;
  double at(double x) const;
};

/// Least squares on the logarithms over the later half of the plottable points, at least three of them. Empty where
/// there are fewer, or where they have one x alone.
std::optional<PowerLaw> fitPowerLaw(const std::vector<PlotPoint>& points);

/// Linear between the logarithms of neighbours; points by ascending x. Empty outside their range.
std::optional<double> interpolateLog(const std::vector<PlotPoint>& points, double x);

/// Which of two error curves (seconds, error) is lower at the largest time that both have reached, as one sentence.
/// Below 2% of difference neither is called closer.
std::string closerSentence(const std::vector<PlotPoint>& a, const std::vector<PlotPoint>& b);

}  // namespace ropelight::view
