#include "app/viewer/widgets/number_entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace ropelight::view {
namespace {

constexpr double widestLimits = 1e6;  // what a linear slider or a logarithmic one without a range can still serve
constexpr double sliderSteps = 1000;

double roundTo(double value, double step) { return std::round(value / step) * step; }

double powerOfTenBelow(double value) { return std::pow(10, std::floor(std::log10(value))); }

}  // namespace

SliderRange sliderRange(const ParamInfo& info, bool whole, double reference) {
  SliderRange range{info.min, info.max, info.logarithmic, whole};
  if (info.high > info.low) {
    range.low = std::max(info.low, info.min);
    range.high = std::min(info.high, info.max);
  } else if (!(info.max - info.min <= widestLimits)) {
    double const middle = reference != 0 && std::isfinite(reference) ? std::abs(reference) : 1;
    range.low = range.logarithmic ? std::max(middle / 100, info.min) : std::max(reference - middle, info.min);
    range.high = std::min(range.logarithmic ? middle * 100 : reference + middle, info.max);
  }
  bool const belowSmallest = range.low <= 0 && (*info.zero || range.logarithmic);
  if (belowSmallest) range.low = whole ? 1 : range.high * 1e-4;
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

double sliderPosition(const SliderRange& range, double value) {
  double const inside = std::clamp(value, range.low, range.high);
  if (!range.logarithmic) return (inside - range.low) / (range.high - range.low);
  return std::log(inside / range.low) / std::log(range.high / range.low);
}

double sliderValue(const SliderRange& range, double position) {
  if (position <= 0) return range.low;
  if (position >= 1) return range.high;
  double value = range.logarithmic ? range.low * std::pow(range.high / range.low, position)
                                   : range.low + position * (range.high - range.low);
  double const step =
      range.logarithmic ? powerOfTenBelow(value) / 100 : powerOfTenBelow((range.high - range.low) / sliderSteps);
  value = roundTo(value, step);
  if (range.whole) value = std::round(value);
  return std::clamp(value, range.low, range.high);
}

template <class T>
T limited(double number, const ParamInfo& info) {
  double const inside = std::clamp(number, info.min, info.max);
  if constexpr (std::is_floating_point_v<T>) {
    constexpr double most = std::numeric_limits<T>::max();
    return T(std::clamp(inside, -most, most));
  } else {
    double const whole = std::round(inside);
    if (whole <= double(std::numeric_limits<T>::lowest())) return std::numeric_limits<T>::lowest();
    if (whole >= double(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
    return T(whole);
  }
}

template <class T>
std::optional<T> parseNumber(const std::string& text, const ParamInfo& info) {
  std::size_t const start = std::min(text.find_first_not_of(" +"), text.size());
  std::size_t const stop = text.find_last_not_of(' ') + 1;
  const char* const first = text.data() + start;
  const char* const last = text.data() + std::max(start, stop);
  if constexpr (std::is_integral_v<T>) {  // a double cannot hold every 64-bit seed
    T exact{};
    auto const [end, status] = std::from_chars(first, last, exact);
    if (status == std::errc{} && end == last && double(exact) >= info.min && double(exact) <= info.max) return exact;
  }
  double number = 0;
  auto const [end, status] = std::from_chars(first, last, number);
  if (status != std::errc{} || end != last || std::isnan(number)) return std::nullopt;
  return limited<T>(number, info);
}

template int limited<int>(double, const ParamInfo&);
template std::uint64_t limited<std::uint64_t>(double, const ParamInfo&);
template float limited<float>(double, const ParamInfo&);
template double limited<double>(double, const ParamInfo&);
template std::optional<int> parseNumber<int>(const std::string&, const ParamInfo&);
template std::optional<std::uint64_t> parseNumber<std::uint64_t>(const std::string&, const ParamInfo&);
template std::optional<float> parseNumber<float>(const std::string&, const ParamInfo&);
template std::optional<double> parseNumber<double>(const std::string&, const ParamInfo&);

std::string shortNumber(std::uint64_t value) { return std::to_string(value); }

std::string shortNumber(double value) {
  bool const whole = std::abs(value) < 1e9 && value == std::round(value);
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

std::string coordinateFormat(double distance) {
  double const digits = distance > 0 ? std::ceil(4 - std::log10(distance)) : 4;
  return fmt::format("%.{}f", int(std::clamp(digits, 0.0, 17.0)));
}

std::string limitsText(const ParamInfo& info) {
  bool const below = std::isfinite(info.max) && info.max < 1e18;
  bool const above = std::isfinite(info.min);
  std::string const unit = *info.unit ? fmt::format(" {}", info.unit) : "";
  if (above && below) return fmt::format("from {} to {}{}", shortNumber(info.min), shortNumber(info.max), unit);
  if (above) return fmt::format("at least {}{}", shortNumber(info.min), unit);
  if (below) return fmt::format("at most {}{}", shortNumber(info.max), unit);
  return *info.unit ? fmt::format("in {}", info.unit) : "";
}

}  // namespace ropelight::view
