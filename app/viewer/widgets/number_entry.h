#pragma once
// Numbers of a `params` list as a person enters them: by slider or as text. No window.

#include <cstdint>
#include <optional>
#include <string>

#include "render/core/params.h"

namespace ropelight::view {

struct SliderRange {
  double low = 0, high = 1;
  bool logarithmic = false;
  bool whole = false;  ///< numbers without a fraction
};

/// From the list's range, else its limits; where those are too wide for a slider, from a hundredth of `reference` to a
/// hundred times of it. Never reaches a 0 that stands for an automatic value.
SliderRange sliderRange(const ParamInfo& info, bool whole, double reference);

/// Where a value lies, clamped to [0, 1].
double sliderPosition(const SliderRange& range, double value);
/// The value there, rounded to what a slider of some hundred pixels can tell apart.
double sliderValue(const SliderRange& range, double position);

/// Clamped to the limits of `info` and of T, and rounded where T is whole. `number` is not NaN.
template <class T>
T limited(double number, const ParamInfo& info);

/// A typed number, clamped to the limits; "1e6" is a whole number too. Empty where it is none, or NaN.
template <class T>
std::optional<T> parseNumber(const std::string& text, const ParamInfo& info);

/// Short, for showing: at most four digits of a fraction, whole numbers in full.
std::string shortNumber(double value);
std::string shortNumber(std::uint64_t value);
inline std::string shortNumber(int value) { return std::to_string(value); }
inline std::string shortNumber(float value) { return shortNumber(double(value)); }

/// printf's format of a coordinate to a ten-thousandth of a viewing distance, wherever the scene lies: significant
/// digits would not do far from the origin, where a dragged coordinate is rounded to what is shown.
std::string coordinateFormat(double distance);

/// "from 0.25 to 16 gather radii", as far as there are limits.
std::string limitsText(const ParamInfo& info);

}  // namespace ropelight::view
