// What is read from the runs of a study, against runs whose answers are known.

#include <doctest/doctest.h>

#include <cmath>

#include "app/converge/analysis/curves.h"
#include "app/converge/analysis/verdict.h"
#include "tests/support/fake_study.h"

namespace ropelight {
namespace {

constexpr CurveAxis seconds = CurveAxis::seconds, iterations = CurveAxis::iterations;

doctest::Approx close(double value) { return doctest::Approx(value).epsilon(1e-9); }

StudyScene sceneOf(std::vector<StudyMode> modes) {
  StudyScene scene;
  scene.modes = std::move(modes);
  return scene;
}

StudyMode modeOf(std::vector<StudyRun> runs) {
  StudyMode mode;
  mode.runs = std::move(runs);
  return mode;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("slopes of power laws are their exponents, on either axis") {
  StudyMode mode = powerMode("path", {1, 2, 4}, -1);
  mode.runs.push_back(powerRun(4, 1, -0.5));
  for (CurveAxis const axis : {seconds, iterations}) {
    Slope const slope = slopeOf(mode, axis, false);
    CHECK(slope.median == close(-1));
    CHECK(slope.low == close(-1));
    CHECK(slope.high == close(-0.5));
  }
}

TEST_CASE("a slope reads the last decade alone, and needs three samples there") {
  auto const bent = [](double t) { return t < 1.5 ? 1 : 1 / t; };  // the last decade of 16 s begins at 1.6 s
  CHECK(slopeOf(modeOf({runOf(1, 11, bent)}), seconds, false).median == close(-1));
  CHECK(slopeOf(modeOf({powerRun(1, 1, -1, 3)}), seconds, false).median == close(-1));
  CHECK(std::isnan(slopeOf(modeOf({powerRun(1, 1, -1, 2)}), seconds, false).median));
  CHECK(std::isnan(slopeOf({}, seconds, false).median));
}

TEST_CASE("bands hold the median and the ends of all runs at common places") {
  StudyMode mode = powerMode("path", {1, 3, 2}, -1);
  mode.runs[1].samples.erase(mode.runs[1].samples.begin());  // starts later
  mode.runs[2].samples.pop_back();                           // ends sooner
  mode.runs[2].samples.erase(mode.runs[2].samples.begin() + 4);
  auto const band = bandOf(mode, seconds, false);
  REQUIRE(band.size() == 9);
  CHECK(band.front().x == 1.0 / 32);
  CHECK(band.back().x == 8);
  for (const BandPoint& p : band) {
    CHECK(p.low == close(1 / p.x));
    CHECK(p.median == close(2 / p.x));
    CHECK(p.high == close(3 / p.x));
  }
  CHECK(bandOf(mode, iterations, true).back().median == close(2.0 / 8 / 2));
}

TEST_CASE("a band reaches to the last place that all runs share, sampled by the first or not") {
  StudyMode mode = powerMode("path", {1, 1}, -1);
  mode.runs[1].samples.back().seconds = 12;
  mode.runs[1].samples.back().metrics.relMse = 1.0 / 12;
  auto const band = bandOf(mode, seconds, false);
  REQUIRE(band.size() == 11);
  CHECK(band.back().x == 12);
  CHECK(band.back().high == close(1.0 / 12));
  CHECK(*commonEnd(mode, seconds, false) == 12);
}

TEST_CASE("runs without samples are left out; those that share no place have no band") {
  StudyMode mode = powerMode("path", {1, 2}, -1);
  mode.runs.push_back({});
  CHECK(seedsOf(mode) == 2);
  CHECK(bandOf(mode, seconds, false).size() == 11);
  CHECK(bandOf({}, seconds, false).empty());
  CHECK_FALSE(commonEnd({}, seconds, false));
  StudyMode apart = modeOf({powerRun(1, 1, -1), powerRun(2, 1, -1)});
  for (ErrorSample& s : apart.runs[1].samples) s.seconds += 100;
  CHECK(bandOf(apart, seconds, false).empty());
  CHECK(bandOf(apart, iterations, false).size() == 11);
}

TEST_CASE("errors of 0 and unknown ones have no place in bands and slopes") {
  StudyMode mode = powerMode("path", {1}, -1);
  mode.runs[0].samples[2].metrics.relMse = 0;
  mode.runs[0].samples[5].metrics.relMse = unknown;
  CHECK(bandOf(mode, seconds, false).size() == 9);
  CHECK(slopeOf(mode, seconds, false).median == close(-1));
  CHECK(bandOf(modeOf({runOf(1, 5, [](double) { return 0.0; })}), seconds, false).empty());
}

TEST_CASE("the time to an error is where the line between logarithms crosses it") {
  TimeTo const time = timeTo(powerMode("path", {0.3, 0.1, 0.2}, -1), 0.1, false);
  CHECK(time.reached == 3);
  CHECK(time.low == close(1));
  CHECK(time.median == close(2));
  CHECK(time.high == close(3));
  CHECK(timeTo(powerMode("path", {0.3, 0.1, 0.2}, -1), 0.1, true).median == close(1));
}

TEST_CASE("an error counts as reached only where it stays") {
  auto const leaping = [](double t) { return t == 4 ? 0.5 : 0.05 / t; };
  TimeTo const time = timeTo(modeOf({runOf(1, 11, leaping)}), 0.1, false);
  CHECK(time.median > 4);
  CHECK(time.median < 8);
  auto const rising = [](double t) { return t == 16 ? 0.2 : 0.01; };
  CHECK(timeTo(modeOf({runOf(1, 11, rising)}), 0.1, false).reached == 0);
}

TEST_CASE("where some runs reach an error, how many is all that is known") {
  TimeTo const time = timeTo(powerMode("path", {0.1, 0.2, 100}, -1), 0.1, false);
  CHECK(time.reached == 2);
  CHECK(std::isnan(time.median));
  CHECK(std::isnan(time.low));
  CHECK(timeTo(powerMode("path", {100}, -1), 0.1, false).reached == 0);
  CHECK(timeTo({}, 0.1, false).reached == 0);
}

TEST_CASE("an error below the limit from the start, or of 0, is reached at a sample") {
  CHECK(timeTo(powerMode("path", {1e-9}, -1), 0.1, false).median == 1.0 / 64);
  auto const falling = [](double t) { return t < 2 ? 1.0 : 0.0; };
  CHECK(timeTo(modeOf({runOf(1, 11, falling)}), 0.1, false).median == 2);
  auto const appearing = [](double t) { return t < 2 ? unknown : 0.01; };
  CHECK(timeTo(modeOf({runOf(1, 11, appearing)}), 0.1, false).median == 2);
}

TEST_CASE("two modes that lie apart have a best") {
  StudyScene const scene = sceneOf({powerMode("path", {8, 9, 10}, -1), powerMode("sppm", {1, 1.5, 2}, -1)});
  CHECK(verdictOf(scene, false) ==
        "After 16 s of run time sppm has the lowest relMSE: 0.0938 (0.0625 to 0.125); next is path with 0.563 (0.5 to "
        "0.625).");
  CHECK(bestAtEqualTime(scene, false) == std::size_t(1));
  CHECK(firstToReach(scene, 0.5, false) == std::nullopt);  // one of path's runs got there
  CHECK(firstToReach(scene, 0.2, false) == std::size_t(1));
  CHECK(firstToReach(scene, 1.0, false) == std::size_t(1));
  CHECK(firstToReach(scene, 1e-9, false) == std::nullopt);
}

TEST_CASE("the same runs with other seeds have no winner, nor have intervals that touch") {
  StudyScene const same = sceneOf({powerMode("a", {1, 2, 3}, -1), powerMode("b", {2, 3, 1}, -1)});
  CHECK(bestAtEqualTime(same, false) == std::nullopt);
  CHECK(firstToReach(same, 0.5, false) == std::nullopt);
  CHECK(verdictOf(same, false) ==
        "No mode is called best: after 16 s of run time the 95% intervals of relMSE overlap between a with 0.125 "
        "(0.0625 to "
        "0.188) and b with 0.125 (0.0625 to 0.188).");
  StudyScene const touching = sceneOf({powerMode("a", {1, 2}, -1), powerMode("b", {2, 3}, -1)});
  CHECK(bestAtEqualTime(touching, false) == std::nullopt);
  StudyScene const third =
      sceneOf({powerMode("a", {1, 1.1}, -1), powerMode("far", {9, 8.9}, -1), powerMode("b", {1.05, 1.2}, -1)});
  CHECK_FALSE(has(verdictOf(third, false), "far"));
}

TEST_CASE("equal time is what the mode that ends first reaches") {
  StudyScene scene = sceneOf({powerMode("a", {1, 1.05}, -1), powerMode("b", {4, 4.1}, -1)});
  scene.modes[0].runs[1].samples.resize(8);
  EqualTime const equal = atEqualTime(scene, false);
  CHECK(equal.seconds == 2);
  CHECK(equal.bands[1]->median == close(2.025));
  CHECK(has(verdictOf(scene, false), "After 2 s of run time a has the lowest relMSE"));
  CHECK(firstToReach(scene, 0.3, false) == std::nullopt);  // a's second run ended before it could
}

TEST_CASE("a mode that stopped before another reached an error is not beaten to it") {
  StudyScene scene = sceneOf({powerMode("a", {1, 1.1}, -1), powerMode("b", {4, 5}, -1)});
  CHECK(firstToReach(scene, 0.1, false) == std::size_t(0));
  for (StudyRun& run : scene.modes[1].runs) run.samples.resize(8);
  CHECK(firstToReach(scene, 0.1, false) == std::nullopt);
}

TEST_CASE("the interval of a geometric mean is Student's of the logarithms") {
  Interval const two = geometricMeanInterval({std::exp(1.0), std::exp(3.0)});  // mean 2, error 1
  CHECK(std::log(two.low) == close(2 - 12.706));
  CHECK(std::log(two.high) == close(2 + 12.706));
  Interval const three = geometricMeanInterval({1, std::exp(1.0), std::exp(2.0)});  // mean 1, deviation 1
  CHECK(std::log(three.high) == close(1 + 4.303 / std::sqrt(3.0)));
  CHECK(geometricMeanInterval({5, 5, 5, 5}).low == close(5));
  for (auto const& none : {std::vector<double>{}, {3}, {1, 0}, {1, -1}}) {
    CHECK(geometricMeanInterval(none).low == 0);
    CHECK(std::isinf(geometricMeanInterval(none).high));
  }
}

TEST_CASE("one seed calls no winner") {
  StudyScene const scene = sceneOf({powerMode("path", {16}, -1), powerMode("sppm", {1}, -1)});
  CHECK(bestAtEqualTime(scene, false) == std::nullopt);
  CHECK(verdictOf(scene, false) ==
        "One seed says nothing of chance, so no mode is called best: after 16 s of run time the lowest relMSE is that "
        "of sppm "
        "with 0.0625, then path with 1.");
}

TEST_CASE("verdicts of what was not measured") {
  CHECK(verdictOf({}, false) == "Nothing was measured.");
  CHECK(verdictOf(sceneOf({StudyMode{}}), false) == "Nothing was measured.");
  StudyMode none;
  none.label = "ray";
  StudyScene const alone = sceneOf({powerMode("path", {1, 2}, -1), none});
  CHECK(verdictOf(alone, true) ==
        "path alone has trimmed relMSE 0.0469 (0.0313 to 0.0625) after 16 s of run time. ray has no samples.");
  CHECK(bestAtEqualTime(alone, false) == std::nullopt);
  StudyScene late = sceneOf({powerMode("a", {1, 2}, -1), powerMode("b", {1, 2}, -1)});
  for (StudyRun& run : late.modes[1].runs)
    for (ErrorSample& s : run.samples) s.seconds += 100;
  CHECK(verdictOf(late, false) == "No run time that all modes have an error at, so they are not compared.");
  CHECK(bestAtEqualTime(late, false) == std::nullopt);
}

}  // namespace ropelight
