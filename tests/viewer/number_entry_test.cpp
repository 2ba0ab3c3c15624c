// Sliders and typed numbers of the panel.

#include "app/viewer/widgets/number_entry.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "render/settings/settings.h"

using namespace ropelight;
using namespace ropelight::view;

TEST_CASE("Typed numbers are clamped to the limits, and what is no number is refused") {
  ParamInfo const info{.min = 1, .max = 4294967295.0};
  CHECK(parseNumber<std::uint64_t>("50000", info) == 50000u);
  CHECK(parseNumber<std::uint64_t>(" 1e6 ", info) == 1000000u);
  CHECK(parseNumber<std::uint64_t>("0", info) == 1u);
  CHECK(parseNumber<std::uint64_t>("-7", info) == 1u);
  CHECK(parseNumber<std::uint64_t>("1e99", info) == 4294967295u);
  for (const char* text : {"", " ", "+", "x", "1x", "nan", "1 2"}) CHECK_FALSE(parseNumber<std::uint64_t>(text, info));
  CHECK(parseNumber<double>("+2.5e-3", ParamInfo{}) == 2.5e-3);
  CHECK_FALSE(parseNumber<double>("nan", ParamInfo{}));
  CHECK(parseNumber<double>("inf", ParamInfo{.max = 16}) == 16);
  CHECK(parseNumber<int>("1e30", ParamInfo{}) == std::numeric_limits<int>::max());
  CHECK(parseNumber<float>("1e300", ParamInfo{}) == std::numeric_limits<float>::max());
}

TEST_CASE("Every seed of 64 bits can be typed") {
  ParamInfo const info{.min = 0, .max = 18446744073709551615.0};
  CHECK(parseNumber<std::uint64_t>("18446744073709551615", info) == 18446744073709551615u);
  CHECK(parseNumber<std::uint64_t>("9007199254740993", info) == 9007199254740993u);
}

TEST_CASE("Every number of the settings has a slider that reaches its ends and its default") {
  Settings settings;
  settings.params([](const char* name, auto& value, const ParamInfo& info) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      INFO(name);
      SliderRange const range = sliderRange(info, std::is_integral_v<T>, 0.02);
      CHECK(range.low < range.high);
      CHECK(range.low >= info.min);
      CHECK(range.high <= info.max);
      CHECK_FALSE((*info.zero && range.low <= 0));
      CHECK(sliderValue(range, 0) == doctest::Approx(range.low));
      CHECK(sliderValue(range, 1) == doctest::Approx(range.high));
      double const middle = sliderValue(range, 0.5);
      CHECK(std::abs(sliderPosition(range, middle) - 0.5) < 0.02);
    }
  });
}

TEST_CASE("Without limits a slider spans a hundredth to a hundred times of what is there") {
  SliderRange const range = sliderRange({.min = 0, .max = 1e30, .logarithmic = true, .zero = "automatic"}, false, 0.02);
  CHECK(range.low == doctest::Approx(0.0002));
  CHECK(range.high == doctest::Approx(2));
  CHECK(sliderPosition(range, 0.02) == doctest::Approx(0.5));
  CHECK(sliderRange({.min = 0, .max = 1e30, .logarithmic = true}, false, 0).high == 100);
}

TEST_CASE("Sliders give round numbers") {
  CHECK(sliderValue({.low = -10, .high = 10}, 0.61237) == doctest::Approx(2.25).epsilon(1e-9));
  CHECK(sliderValue({.low = 1, .high = 1000, .logarithmic = true}, 0.7) == doctest::Approx(126).epsilon(1e-9));
  CHECK(sliderValue({.low = 1, .high = 10, .whole = true}, 0.5) == 6);
}

TEST_CASE("Numbers and limits are said shortly") {
  CHECK(shortNumber(262144.0) == "262144");
  CHECK(shortNumber(0.0123456) == "0.01235");
  CHECK(limitsText({.min = 0.25, .max = 16, .unit = "gather radii"}) == "from 0.25 to 16 gather radii");
  CHECK(limitsText({.min = 0, .max = 1e30}) == "at least 0");
  CHECK(limitsText({}) == "");
}

TEST_CASE("Coordinates are shown finely enough for the viewing distance") {
  CHECK(coordinateFormat(8) == "%.4f");
  CHECK(coordinateFormat(0.002) == "%.7f");
  CHECK(coordinateFormat(5e6) == "%.0f");
  CHECK(coordinateFormat(1e-15) == "%.17f");
  CHECK(coordinateFormat(0) == "%.4f");
}
