#include "app/plot/plot_math.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ropelight::view {
namespace {

constexpr double narrowest = 3;        // factor that an axis spans at least
constexpr double equallyClose = 0.02;  // relative difference that noise alone may make
constexpr double smallest = 1e-300, largest = 1e300;

bool inside(LogRange range, double v) { return v >= range.low && v <= range.high; }

}  // namespace

LogRange logRange(const std::vector<double>& values, double margin) {
  double low = largest, high = 0;
  for (double v : values) {
    if (!isPlottable({v, v})) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (high == 0) return {};
  double const lowLog = std::log10(std::clamp(low, smallest, largest));
  double const highLog = std::log10(std::clamp(high, smallest, largest));
  double const half = std::max((highLog - lowLog) * (0.5 + margin), std::log10(narrowest) / 2);
  double const middle = (lowLog + highLog) / 2;
  return {std::max(std::pow(10, middle - half), smallest), std::min(std::pow(10, middle + half), largest)};
}

double logPosition(LogRange range, double value) {
  return (std::log(value) - std::log(range.low)) / (std::log(range.high) - std::log(range.low));
}

double logValue(LogRange range, double position) {
  return std::exp(std::log(range.low) + position * (std::log(range.high) - std::log(range.low)));
}

std::vector<AxisTick> logTicks(LogRange range, int mostLabels) {
  int const first = int(std::floor(std::log10(range.low)));
  int const last = int(std::ceil(std::log10(range.high)));
  int const stride = std::max(1, (last - first + mostLabels - 1) / std::max(mostLabels, 1));
  int decades = 0;
  for (int e = first; e <= last; ++e) decades += inside(range, std::pow(10, e)) ? 1 : 0;

  std::vector<AxisTick> ticks;
  for (int e = first; e <= last; e += stride)
    for (int step = 1; step <= (stride == 1 ? 9 : 1); ++step) {
      double const value = step * std::pow(10, e);
      if (!inside(range, value)) continue;
      bool const labelled = step == 1 || (decades < 2 && (step == 2 || step == 5));
      ticks.push_back({value, labelled ? fmt::format("{:.3g}", value) : std::string()});
    }
  return ticks;
}

std::string closerSentence(const std::vector<PlotPoint>& a, const std::vector<PlotPoint>& b) {
  std::vector<PlotPoint> const usableA = plottable(a), usableB = plottable(b);
  if (usableA.empty() || usableB.empty()) return "Not yet measured for both.";
  double const time = std::min(usableA.back().x, usableB.back().x);
  auto const errorA = interpolateLog(usableA, time), errorB = interpolateLog(usableB, time);
  if (!errorA || !errorB) return "No run time yet that both have reached.";
  std::string const figures =
      fmt::format("{:.3g} against {:.3g}", std::min(*errorA, *errorB), std::max(*errorA, *errorB));
  if (std::abs(*errorA - *errorB) <= equallyClose * std::max(*errorA, *errorB))
    return fmt::format("A and B are equally close after the same time: {} at {:.3g} s.", figures, time);
  return fmt::format("{} is closer after the same time: {} at {:.3g} s.", *errorA < *errorB ? "A" : "B", figures, time);
}

}  // namespace ropelight::view
