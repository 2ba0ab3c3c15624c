#include "app/converge/analysis/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bench/results/result.h"
#include "app/plot/curve_math.h"

namespace ropelight {
namespace {

using Points = std::vector<PlotPoint>;

double placeOf(const ErrorSample& sample, CurveAxis axis) {
  return axis == CurveAxis::seconds ? sample.seconds : double(sample.iterations);
}

/// Of every run that has points with logarithms, those points.
std::vector<Points> curvesOf(const StudyMode& mode, CurveAxis axis, bool trimmed) {
  std::vector<Points> curves;
  for (const StudyRun& run : mode.runs) {
    Points points;
    for (const ErrorSample& s : run.samples) points.push_back({placeOf(s, axis), errorOf(s.metrics, trimmed)});
    points = plottable(points);
    if (!points.empty()) curves.push_back(std::move(points));
  }
  return curves;
}

struct Range {
  double first = 0, last = 0;
};

std::optional<Range> commonRange(const std::vector<Points>& curves) {
  Range range{0, std::numeric_limits<double>::infinity()};
  for (const Points& points : curves) {
    range.first = std::max(range.first, points.front().x);
    range.last = std::min(range.last, points.back().x);
  }
  if (curves.empty() || range.first > range.last) return std::nullopt;
  return range;
}

std::optional<BandPoint> bandAt(const std::vector<Points>& curves, double x) {
  std::vector<double> errors;
  for (const Points& points : curves) {
    auto const error = interpolateLog(points, x);
    if (!error) return std::nullopt;
    errors.push_back(*error);
  }
  if (errors.empty()) return std::nullopt;
  Spread const s = summarise(errors);
  return BandPoint{x, s.median, s.min, s.max, geometricMeanInterval(errors)};
}

/// Where the line between the logarithms of two samples crosses `error`; the later sample's time where there is no such
/// line.
double crossing(PlotPoint above, PlotPoint below, double error) {
  if (!isPlottable(above) || !isPlottable(below)) return below.x;
  double const share = std::log(above.y / error) / std::log(above.y / below.y);
  return std::exp(std::log(above.x) * (1 - share) + std::log(below.x) * share);
}

/// A sample without a valid error counts as above.
std::optional<double> timeTo(const StudyRun& run, double error, bool trimmed) {
  auto const pointOf = [&](const ErrorSample& s) { return PlotPoint{s.seconds, errorOf(s.metrics, trimmed)}; };
  auto const above = [&](const ErrorSample& s) { return !(errorOf(s.metrics, trimmed) <= error); };
  auto const lastAbove = std::find_if(run.samples.rbegin(), run.samples.rend(), above);
  if (lastAbove == run.samples.rbegin()) return std::nullopt;
  if (lastAbove == run.samples.rend()) return run.samples.front().seconds;
  return crossing(pointOf(*lastAbove), pointOf(*(lastAbove - 1)), error);
}

}  // namespace

double errorOf(const Metrics& metrics, bool trimmed) { return trimmed ? metrics.relMseTrimmed : metrics.relMse; }

int seedsOf(const StudyMode& mode) {
  return int(std::count_if(mode.runs.begin(), mode.runs.end(), [](const StudyRun& r) { return !r.samples.empty(); }));
}

std::optional<double> commonEnd(const StudyMode& mode, CurveAxis axis, bool trimmed) {
  auto const range = commonRange(curvesOf(mode, axis, trimmed));
  return range ? std::optional(range->last) : std::nullopt;
}

std::optional<BandPoint> bandAt(const StudyMode& mode, CurveAxis axis, bool trimmed, double x) {
  return bandAt(curvesOf(mode, axis, trimmed), x);
}

std::vector<BandPoint> bandOf(const StudyMode& mode, CurveAxis axis, bool trimmed) {
  auto const curves = curvesOf(mode, axis, trimmed);
  auto const range = commonRange(curves);
  if (!range) return {};
  std::vector<double> places;
  for (PlotPoint p : curves.front())
    if (p.x >= range->first && p.x <= range->last) places.push_back(p.x);
  if (places.empty() || places.back() < range->last) places.push_back(range->last);
  std::vector<BandPoint> band;
  for (double const x : places)
    if (auto const point = bandAt(curves, x)) band.push_back(*point);
  return band;
}

Slope slopeOf(const StudyMode& mode, CurveAxis axis, bool trimmed) {
  std::vector<double> slopes;
  for (const Points& points : curvesOf(mode, axis, trimmed))
    if (auto const law = fitLastDecade(points)) slopes.push_back(law->exponent);
  if (slopes.empty()) return {};
  Spread const s = summarise(slopes);
  return {s.median, s.min, s.max};
}

TimeTo timeTo(const StudyMode& mode, double error, bool trimmed) {
  std::vector<double> times;
  for (const StudyRun& run : mode.runs)
    if (auto const time = timeTo(run, error, trimmed)) times.push_back(*time);
  TimeTo result{.reached = int(times.size())};
  if (times.empty() || result.reached < seedsOf(mode)) return result;
  Spread const s = summarise(times);
  result.median = s.median, result.low = s.min, result.high = s.max;
  result.likely = geometricMeanInterval(times);
  return result;
}

}  // namespace ropelight
