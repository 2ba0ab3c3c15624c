// Axes, fits and interpolation of log-log plots against values worked by hand.

#include "app/plot/plot_math.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace ropelight::view;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<PlotPoint> powers(double factor, double exponent, int count) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < count; ++i) points.push_back({std::pow(2, i), factor * std::pow(2, i * exponent)});
  return points;
}

std::vector<std::string> labels(LogRange range, int most) {
  std::vector<std::string> found;
  for (const AxisTick& tick : logTicks(range, most))
    if (!tick.label.empty()) found.push_back(tick.label);
  return found;
}

}  // namespace

TEST_CASE("A power law is recovered from its points") {
  auto const law = fitLastDecade(powers(0.25, -0.75, 9));
  REQUIRE(law);
  CHECK(law->exponent == doctest::Approx(-0.75).epsilon(1e-12));
  CHECK(law->factor == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(law->at(16) == doctest::Approx(0.25 / 8).epsilon(1e-12));
}

TEST_CASE("The fit reads the last decade alone") {
  std::vector<PlotPoint> points = powers(1, -1, 8);
  for (std::size_t i = 0; i < 4; ++i) points[i].y = 1000;  // the start of a run says nothing about its end
  CHECK(fitLastDecade(points)->exponent == doctest::Approx(-1).epsilon(1e-12));
  points[4].y = 1000;
  CHECK(fitLastDecade(points)->exponent < -1.1);
}

TEST_CASE("A fit needs three points of different x that have logarithms") {
  CHECK_FALSE(fitLastDecade({}));
  CHECK_FALSE(fitLastDecade({{1, 1}, {2, 0.5}}));
  CHECK_FALSE(fitLastDecade({{3, 1}, {3, 0.5}, {3, 0.25}}));
  CHECK_FALSE(fitLastDecade({{1, 1}, {2, 0}, {4, notANumber}, {8, infinity}, {16, 0.1}}));
  auto const law = fitLastDecade({{0, 5}, {1, 1}, {2, 0.5}, {notANumber, 1}, {4, 0.25}, {8, -1}});
  REQUIRE(law);
  CHECK(law->exponent == doctest::Approx(-1).epsilon(1e-12));
}

TEST_CASE("Interpolation is linear between logarithms and does not leave the points") {
  std::vector<PlotPoint> const points{{1, 1}, {100, 0.01}, {400, 0.0025}};
  CHECK(*interpolateLog(points, 10) == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(*interpolateLog(points, 200) == doctest::Approx(0.005).epsilon(1e-12));
  CHECK(*interpolateLog(points, 1) == 1);
  CHECK(*interpolateLog(points, 400) == 0.0025);
  CHECK_FALSE(interpolateLog(points, 0.5));
  CHECK_FALSE(interpolateLog(points, 401));
  CHECK_FALSE(interpolateLog(points, notANumber));
  CHECK_FALSE(interpolateLog({}, 1));
}

TEST_CASE("The closer estimate is named at the time that both have reached") {
  std::vector<PlotPoint> const a{{1, 0.1}, {10, 0.01}, {100, 0.001}};
  std::vector<PlotPoint> const b{{1, 0.2}, {10, 0.05}};
  CHECK(closerSentence(a, b) == "A is closer after the same time: 0.01 against 0.05 at 10 s.");
  CHECK(closerSentence(b, a) == "B is closer after the same time: 0.01 against 0.05 at 10 s.");
  CHECK(closerSentence(a, a) == "A and B are equally close after the same time: 0.001 against 0.001 at 100 s.");
  CHECK(closerSentence(a, {}) == "Not yet measured for both.");
  CHECK(closerSentence({{5, 1}, {6, 1}}, {{1, 1}, {2, 1}}) == "No run time yet that both have reached.");
}

TEST_CASE("An axis spans what can be shown, with a margin") {
  LogRange const range = logRange({1, 100, 0, -3, notANumber, infinity}, 0.05);
  CHECK(range.low == doctest::Approx(std::pow(10, -0.1)).epsilon(1e-12));
  CHECK(range.high == doctest::Approx(std::pow(10, 2.1)).epsilon(1e-12));
  CHECK(logPosition(range, 10) == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(logValue(range, 0.5) == doctest::Approx(10).epsilon(1e-12));
}

TEST_CASE("An axis of one value, of none and of extreme ones can be drawn") {
  LogRange const one = logRange({7});
  CHECK(one.high / one.low == doctest::Approx(3).epsilon(1e-12));
  CHECK(logPosition(one, 7) == doctest::Approx(0.5).epsilon(1e-12));
  LogRange const none = logRange({0, notANumber});
  CHECK(none.low < none.high);
  LogRange const extreme = logRange({5e-324, 1.7e308});
  CHECK(extreme.low > 0);
  CHECK(std::isfinite(extreme.high));
  CHECK(logTicks(extreme, 6).size() <= 8);
}

TEST_CASE("Ticks are powers of ten; narrow axes label 2 and 5 too") {
  CHECK(labels({0.5, 200}, 8) == std::vector<std::string>{"1", "10", "100"});
  CHECK(labels({0.9, 6}, 8) == std::vector<std::string>{"1", "2", "5"});
  CHECK(logTicks({1, 100}, 8).size() == 19);
  CHECK(labels({1e-6, 1e6}, 6).size() <= 7);
}
