#include "app/plot/svg_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/plot_math.h"

namespace ropelight {
namespace {

constexpr int mostLabels = 12;
constexpr double wantedSteps = 5;

std::string superscript(int number) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (char const c : fmt::format("{}", number)) text += c == '-' ? "⁻" : digits[c - '0'];
  return text;
}

/// 1, 2 or 5 times a power of ten; `divisions` is how many minor steps it is cut into.
double niceStep(double rough, int& divisions) {
  double const decade = std::pow(10, std::floor(std::log10(rough))), share = rough / decade;
  divisions = share > 1 && share <= 2 ? 4 : 5;
  return decade * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
}

}  // namespace

std::string tickLabel(double value) {
  double const size = std::abs(value);
  if (value == 0 || (size < 1e4 * (1 - 1e-9) && size > 1e-3 * (1 + 1e-9))) return fmt::format("{:.6g}", value);
  int exponent = int(std::floor(std::log10(size) + 1e-9));
  std::string const mantissa = fmt::format("{:.4g}", value / std::pow(10, exponent));
  std::string const power = "10" + superscript(exponent);
  if (mantissa == "1") return power;
  return mantissa == "-1" ? "-" + power : mantissa + "·" + power;
}

AxisScale::AxisScale(const PlotAxis& axis, const std::vector<double>& values)
    : logarithmic_(axis.logarithmic && axis.names.empty()) {
  if (!axis.names.empty())
    fitNames(axis.names);
  else if (logarithmic_)
    fitLogarithmic(values);
  else
    fitLinear(values);
}

bool AxisScale::hasPlace(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }

double AxisScale::position(double value) const {
  if (logarithmic_) return view::logPosition({low_, high_}, value);
  return (value - low_) / (high_ - low_);
}

void AxisScale::fitNames(const std::vector<std::string>& names) {
  low_ = -0.5;
  high_ = double(names.size()) - 0.5;
  for (std::size_t i = 0; i < names.size(); ++i) ticks_.push_back({double(i), names[i]});
}

void AxisScale::fitLogarithmic(const std::vector<double>& values) {
  view::LogRange const range = view::logRange(values);
  low_ = range.low;
  high_ = range.high;
  for (const view::AxisTick& tick : view::logTicks(range, mostLabels))
    ticks_.push_back({tick.value, tick.label.empty() ? "" : tickLabel(tick.value)});
}

void AxisScale::fitLinear(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (double const v : values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (!(low <= high)) low = 0, high = 1;
  if (low > 0 && low < 0.5 * high) low = 0;
  if (low == high) low -= 0.5 * std::max(1.0, std::abs(low)), high += 0.5 * std::max(1.0, std::abs(high));
  int divisions;
  double const step = niceStep((high - low) / wantedSteps, divisions);
  int const first = int(std::floor(low / step + 1e-9)), last = int(std::ceil(high / step - 1e-9));
  low_ = first * step;
  high_ = last * step;
  for (int i = first; i <= last; ++i) {
    ticks_.push_back({i * step, fmt::format("{:.6g}", i * step)});
    for (int k = 1; k < divisions && i < last; ++k) ticks_.push_back({(i + double(k) / divisions) * step, ""});
  }
}

}  // namespace ropelight
