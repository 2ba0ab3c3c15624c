#pragma once
// Curves on logarithmic axes: which points have a place there, power laws, interpolation.

#include <optional>
#include <vector>

namespace ropelight {

struct PlotPoint {
  double x = 0, y = 0;
};

/// Both coordinates are positive and finite, so that they have a place on logarithmic axes.
bool isPlottable(PlotPoint p);
std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points);

/// y = factor · x^exponent.
struct PowerLaw {
  double factor = 0, exponent = 0;
  double at(double x) const;
};

/// Least squares on the logarithms over the plottable points from a tenth of the last one's x on; points by ascending
/// x. Empty where those are fewer than three, or have one x alone.
std::optional<PowerLaw> fitLastDecade(const std::vector<PlotPoint>& points);

/// Linear between the logarithms of neighbours; points by ascending x. Empty outside their range.
std::optional<double> interpolateLog(const std::vector<PlotPoint>& points, double x);

struct Interval {
  double low = 0, high = 0;
};

/// Where the geometric mean of what positive values were drawn from lies, with 95% confidence: Student's interval of
/// their logarithms. From 0 to infinity for fewer than two values, or with one that is not positive.
Interval geometricMeanInterval(const std::vector<double>& values);

}  // namespace ropelight
