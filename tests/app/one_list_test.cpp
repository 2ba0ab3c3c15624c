// A subcommand and a benchmark that are in the list are found, named in help and errors, and run.

#include <doctest/doctest.h>

#include <filesystem>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/results/result.h"
#include "app/cli/options.h"
#include "render/core/error.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

constexpr Subcommand dummyCommand{"dummy", "[WORD...]", "Counts its words.", [](const Subcommand&, Arguments words) {
                                    return Command([n = int(words.size())] { return n; });
                                  }};

std::vector<const Subcommand*> withDummy() {
  auto const table = subcommands();
  std::vector<const Subcommand*> all(table.begin(), table.end());
  all.push_back(&dummyCommand);
  return all;
}

std::vector<Bench> benchesWithDummy() {
  std::vector<Bench> all(benches().begin(), benches().end());
  all.push_back({"dummy", [](const BenchOptions& o) { return startResult("dummy", "no device", o, "none"); }, false});
  return all;
}

}  // namespace

TEST_CASE("a subcommand is one word of the list") {
  const char* const line[] = {"ropelight", "dummy", "a", "b"};
  CHECK(parseCommandLine(4, line, withDummy())() == 2);
  CHECK(overview(withDummy()).find("ropelight dummy [WORD...]") != std::string::npos);
  CHECK(overview().find("dummy") == std::string::npos);
  for (const Subcommand* s : subcommands())
    CHECK(overview().find(std::string("ropelight ") + s->name) != std::string::npos);
}

TEST_CASE("a benchmark is one line of the list") {
  std::vector<Bench> const table = benchesWithDummy();
  CHECK(benchNames(table).back() == "dummy");
  TemporaryFolder const folder;
  BenchOptions options;
  options.names = {"dummy"};
  options.out = folder.path().string();
  CHECK(runBench(options, table) == 0);
  CHECK(std::filesystem::exists(folder.path() / "dummy.csv"));
  CHECK_THROWS_WITH_AS(runBench(options), doctest::Contains("there is no benchmark 'dummy'; there are: iteration"),
                       Error);
  options.names = {"nothing"};
  CHECK_THROWS_WITH_AS(runBench(options, table), doctest::Contains("display, dummy"), Error);
}
