// Summaries of the stages' times.

#include "app/viewer/session/stage_history.h"

#include <doctest/doctest.h>

#include <limits>

using namespace ropelight::view;

TEST_CASE("Stages are summed up over the batches that had them") {
  std::deque<StageSample> const history{{{"trace", 0.002}, {"gather", 0.001}},
                                        {{"trace", 0.004}},
                                        {{"trace", std::numeric_limits<double>::quiet_NaN()}, {"gather", 0.003}}};
  auto const stages = summarizeStages(history);
  REQUIRE(stages.size() == 2);
  CHECK(stages[0].name == "trace");
  CHECK(stages[0].least == doctest::Approx(2));
  CHECK(stages[0].mean == doctest::Approx(3));
  CHECK(stages[0].most == doctest::Approx(4));
  CHECK(stages[1].mean == doctest::Approx(2));
  CHECK(longestSample(history) == doctest::Approx(4));
  CHECK(summarizeStages({}).empty());
  CHECK(longestSample({}) == 0);
}
