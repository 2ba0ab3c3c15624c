#include "app/plot/curve_math.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace ropelight {
namespace {

constexpr std::size_t fewest = 3;  // two points have a line through them, whatever the noise

bool isPositive(double v) { return v > 0 && std::isfinite(v); }

/// Least squares on the logarithms of points that have them.
std::optional<PowerLaw> fitAll(std::span<const PlotPoint> points) {
  if (points.size() < fewest) return std::nullopt;
  double meanX = 0, meanY = 0;
  for (PlotPoint p : points) {
    meanX += std::log(p.x) / double(points.size());
    meanY += std::log(p.y) / double(points.size());
  }
  double xx = 0, xy = 0;
  for (PlotPoint p : points) {
    double const dx = std::log(p.x) - meanX;
    xx += dx * dx;
    xy += dx * (std::log(p.y) - meanY);
  }
  if (!(xx > 1e-12)) return std::nullopt;
  double const exponent = xy / xx;
  return PowerLaw{std::exp(meanY - exponent * meanX), exponent};
}

}  // namespace

bool isPlottable(PlotPoint p) { return isPositive(p.x) && isPositive(p.y); }

std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> kept;
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept), isPlottable);
  return kept;
}

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

std::optional<PowerLaw> fitLastDecade(const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> const usable = plottable(points);
  if (usable.empty()) return std::nullopt;
  double const start = usable.back().x / 10 * (1 - 1e-9);  // a point at the tenth itself belongs to it
  auto const first = std::find_if(usable.begin(), usable.end(), [&](PlotPoint p) { return p.x >= start; });
  return fitAll({first, usable.end()});
}

std::optional<double> interpolateLog(const std::vector<PlotPoint>& points, double x) {
  std::vector<PlotPoint> const usable = plottable(points);
  if (usable.empty() || !(x >= usable.front().x && x <= usable.back().x)) return std::nullopt;
  auto const after = std::lower_bound(usable.begin(), usable.end(), x, [](PlotPoint p, double t) { return p.x < t; });
  if (after->x == x) return after->y;
  PlotPoint const a = *(after - 1), b = *after;
  double const share = (std::log(x) - std::log(a.x)) / (std::log(b.x) - std::log(a.x));
  return std::exp(std::log(a.y) * (1 - share) + std::log(b.y) * share);
}

Interval geometricMeanInterval(const std::vector<double>& values) {
  // 97.5% quantiles of Student's t for 1, 2, … degrees of freedom; from 11 on that of 10, which is wider.
  constexpr double quantiles[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  Interval const all{0, std::numeric_limits<double>::infinity()};
  std::size_t const n = values.size();
  if (n < 2) return all;
  double mean = 0, squares = 0;
  for (double const v : values) mean += std::log(v) / double(n);
  if (!std::isfinite(mean)) return all;
  for (double const v : values) squares += (std::log(v) - mean) * (std::log(v) - mean);
  double const error = std::sqrt(squares / double(n - 1) / double(n));
  double const reach = quantiles[std::min(n - 2, std::size(quantiles) - 1)] * error;
  return {std::exp(mean - reach), std::exp(mean + reach)};
}

}  // namespace ropelight
