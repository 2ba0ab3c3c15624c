// The short catalogue holds, and what the subcommand makes of it.

#include <doctest/doctest.h>

#include <limits>

#include "app/stress/catalogue.h"
#include "app/stress/report/report.h"
#include "app/stress/stress.h"
#include "render/core/error.h"
#include "tests/support/rendering.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

Measurement measured(double value, double noise, double bound) { return {"path", 1, value, noise, 1, bound}; }

CaseResult resultOf(std::vector<Measurement> measurements) {
  CaseResult result;
  result.measurements = std::move(measurements);
  return result;
}

}  // namespace

TEST_CASE("stress: a measurement holds within its bound, and only where its noise can tell") {
  CHECK(measured(1.009, 0.001, 0.01).holds());
  CHECK(measured(1.0139, 0.001, 0.01).holds());
  CHECK_FALSE(measured(1.0141, 0.001, 0.01).holds());
  CHECK_FALSE(measured(1.0, 0.02, 0.01).holds());
  CHECK_FALSE(measured(std::numeric_limits<double>::quiet_NaN(), 0, 0.01).holds());
  CHECK_FALSE(measured(std::numeric_limits<double>::infinity(), 0, 0.01).holds());
  CHECK(resultOf({measured(1, 0, 0)}).verdict() == Holds::yes);
  CHECK(resultOf({measured(1, 0, 0), measured(2, 0, 0)}).verdict() == Holds::no);
  CHECK(resultOf({}).verdict() == Holds::no);
  CaseResult dark = resultOf({measured(1, 0, 0)});
  dark.nonFinite = 1;
  CHECK(dark.verdict() == Holds::no);
  CHECK(resultOf({measured(1.5, 0, 1), measured(2, 0, 1.2), measured(1, 0, 0)}).worst()->value == 2);
}

TEST_CASE("stress: cases are chosen by name, by family, and by --short") {
  std::vector<StressFamily> const pipe = chooseCases(stressCatalogue(), {"light pipe"}, false);
  REQUIRE(pipe.size() == 1);
  CHECK(pipe[0].cases.size() == 1);
  CHECK(chooseCases(stressCatalogue(), {"limits", "light pipe"}, false).size() == 2);
  CHECK_THROWS_WITH_AS(chooseCases(stressCatalogue(), {"light tube"}, false),
                       doctest::Contains("there is no case or family 'light tube'; there are"), Error);
  CHECK_THROWS_WITH_AS(chooseCases(stressCatalogue(), {"far vertices"}, true), doctest::Contains("leave out --short"),
                       Error);
}

TEST_CASE("stress: table, JSON, plots and page tell the same") {
  StressFamily family{"dummies", "for this test", {}};
  family.cases.push_back({"sweep", "<hard>", "size", "value", "1", "0.1", true, [](Probe&) {
                            return std::vector<Measurement>{{"path", 1, 1, 0, 1, 0.1},
                                                            {"path", 10, 1.05, 0, 1, 0.1},
                                                            {"path", 100, 1.5, 0, 1, 0.1}};
                          }});
  family.cases.push_back({"elsewhere", "", "", "", "", "", true,
                          [](Probe&) -> std::vector<Measurement> { throw LeftOut{"only on the moon"}; }});
  StressRun const run = runCases({family}, StressOptions{});
  CHECK(run.failed());
  CHECK(summary(run) == "FAILED: 1 of 2 cases do not hold, 1 left out here");
  nlohmann::ordered_json const json = toJson(run);
  CHECK(json["cases"][0]["verdict"] == "FAILS");
  CHECK(json["cases"][0]["measurements"][1]["holds"] == true);
  CHECK(json["cases"][1]["left out"] == "only on the moon");
  LinePlot plot;
  CHECK(sweepPlot(family.cases[0], run.results[0], plot));
  CHECK(plot.curves.size() == 2);
  CHECK_FALSE(sweepPlot(family.cases[1], run.results[1], plot));
  std::string const page = stabilityPage(run);
  CHECK(page.find("&lt;hard&gt;") != std::string::npos);
  CHECK(page.find("only on the moon") != std::string::npos);
  TemporaryFolder const folder;
  writeReport(run, folder.path().string());
  CHECK(std::filesystem::exists(folder.path() / "stability.html"));
  CHECK(std::filesystem::exists(folder.path() / "dummies-sweep.svg"));
}

TEST_SUITE("slow") {
  TEST_CASE("stress: the short catalogue holds") {
    StressOptions options;
    options.isShort = true;
    options.backend = {BackendKind::cpu, 0, 0, false};
    StressRun const run = runCases(chooseCases(stressCatalogue(), {}, true), options);
    for (const CaseResult& result : run.results) {
      INFO(result.family, ": ", result.name);
      for (const Measurement& m : result.measurements) {
        CAPTURE(m.series);
        CAPTURE(m.parameter);
        CAPTURE(m.value);
        CAPTURE(m.noise);
        CHECK(m.holds());
      }
      CHECK(result.nonFinite == 0);
    }
    CHECK_FALSE(run.failed());
  }
}
