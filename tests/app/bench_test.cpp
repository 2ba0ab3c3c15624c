// What `ropelight bench` makes of its measurements, and that it notices wrong results.

#include <doctest/doctest.h>

#include <cmath>

#include "app/bench/rays.h"
#include "app/bench/results/checks.h"
#include "app/bench/results/timing.h"
#include "measure/rays/meshes.h"
#include "tests/support/program.h"

namespace ropelight {
namespace {

constexpr std::uint32_t missed = 0xFFFFFFFFu;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

BenchRow rowOf(const std::string& series, double x, std::vector<double> seconds) {
  BenchRow row;
  row.series = series;
  row.x = std::to_string(int(x));
  row.place = x;
  row.seconds = std::move(seconds);
  return row;
}

BenchResult resultOf(std::vector<BenchRow> rows) {
  BenchResult result;
  result.bench = "bench";
  result.device = "a \"device\"";
  result.seed = 7;
  result.settings = "settings";
  result.repeat = 3;
  result.tables = {{"table", "triangles", std::move(rows), {"a remark"}}};
  return result;
}

/// Passes everything on, but for one hit of one traversal.
class LyingStream final : public RayStream {
 public:
  LyingStream(RayStream& honest, Traversal liar) : honest_(honest), liar_(liar) {}

  bool supports(Traversal traversal) const override { return honest_.supports(traversal); }
  void setRays(std::span<const StreamRay> rays) override { honest_.setRays(rays); }
  double trace(Traversal traversal, bool anyHit) override {
    lying_ = traversal == liar_;
    return honest_.trace(traversal, anyHit);
  }
  std::vector<StreamHit> hits() override {
    std::vector<StreamHit> hits = honest_.hits();
    if (lying_) hits.back() = {hits.back().t * 1.001f, hits.back().primitive + 1};
    return hits;
  }
  DeviceInfo device() const override { return honest_.device(); }

 private:
  RayStream& honest_;
  Traversal liar_;
  bool lying_ = false;
};

BenchOptions quickOptions() {
  BenchOptions options;
  options.scene.backend.backend = BackendKind::cpu;
  options.repeat = 2;
  return options;
}

}  // namespace

TEST_CASE("the median of an even number of runs lies between the middle two") {
  Spread const s = summarise({4, 1, 3, 2});
  CHECK(s.median == 2.5);
  CHECK(s.min == 1);
  CHECK(s.max == 4);
  CHECK(summarise({3, 1, 2}).median == 2);
}

TEST_CASE("contenders run in turn, warm-up rounds untimed") {
  std::string order;
  Contender contenders[] = {{[&] { return order += 'a', 1.0; }, {}}, {[&] { return order += 'b', 2.0; }, {}}};
  timeInTurn(contenders, 2, 3, 1000);
  CHECK(order == "ababababab");
  CHECK(contenders[0].seconds == std::vector<double>{1, 1, 1});
  CHECK(contenders[1].seconds == std::vector<double>{2, 2, 2});
}

TEST_CASE("slow contenders run less often, but once at least") {
  Contender slow[] = {{[] { return 10.0; }, {}}};
  timeInTurn(slow, 3, 15, 45);  // one round of 10 s to warm up, then three more within 45 s
  CHECK(slow[0].seconds.size() == 3);
  slow[0].seconds.clear();
  timeInTurn(slow, 3, 15, 0.1);
  CHECK(slow[0].seconds.size() == 1);
}

TEST_CASE("CSV has a line a row under one header, and quotes text") {
  BenchRow row = rowOf("a, \"b\"", 10, {0.2, 0.1, 0.4});
  row.setRate(5e6, "rays");
  row.note = "note";
  BenchRow untimed = rowOf("c", 20, {});
  untimed.value = 1.5;
  untimed.unit = "SAH cost";
  untimed.settings = "more";
  CHECK(toCsv({resultOf({row, untimed})}) ==
        "bench,table,series,x,median_s,min_s,max_s,rate,unit,device,threads,seed,settings,note\n"
        "bench,\"table\",\"a, \"\"b\"\"\",\"10\",0.2,0.1,0.4,25,\"Mrays/s\",\"a "
        "\"\"device\"\"\",0,7,\"settings\",\"note\"\n"
        "bench,\"table\",\"c\",\"20\",,,,1.5,\"SAH cost\",\"a \"\"device\"\"\",0,7,\"settings more\",\"\"\n");
}

TEST_CASE("the table for a terminal is aligned and says what is special") {
  BenchRow estimated = rowOf("brute", 1000, {0.2, 0.1});
  estimated.estimated = true;
  estimated.note = "5 of 10 rays";
  std::string const text = toText(resultOf({rowOf("bvh", 10, {0.002, 0.001, 0.004}), estimated}));
  CAPTURE(text);
  CHECK(has(text, "         triangles  median ms  min  max\n"));
  CHECK(has(text, "  bvh           10          2    1    4\n"));
  CHECK(has(text, "  brute       1000       ~150  100  200    5 of 10 rays; 2 runs\n"));
  CHECK(has(text, "a remark\n"));
}

TEST_CASE("JSON has the runs, and what a benchmark adds") {
  BenchRow row = rowOf("a", 10, {0.2, 0.1, 0.4});
  row.details = {{"stats", 5}};
  auto const json = toJson({resultOf({row})});
  REQUIRE(json.size() == 1);
  CHECK(json[0]["bench"] == "bench");
  CHECK(json[0]["median"] == 0.2);
  CHECK(json[0]["seconds"].size() == 3);
  CHECK(json[0]["stats"] == 5);
}

TEST_CASE("curves gather the rows of a series, in milliseconds or as rates") {
  BenchRow a = rowOf("a", 10, {0.2, 0.1, 0.4}), failed = rowOf("a", 20, {});
  a.setRate(1e6, "rays");
  failed.failed = true;
  BenchResult const result = resultOf({a, rowOf("b", 10, {1, 1, 1}), failed});
  CHECK(result.failed());
  auto const times = curvesOf(result.tables[0], Plotted::milliseconds);
  REQUIRE(times.size() == 2);
  REQUIRE(times[0].points.size() == 1);
  CHECK(times[0].points[0].y == doctest::Approx(200));
  CHECK(times[0].points[0].low == doctest::Approx(100));
  CHECK(times[0].points[0].high == doctest::Approx(400));
  auto const rates = curvesOf(result.tables[0], Plotted::value);
  CHECK(rates[0].points[0].y == doctest::Approx(5));
  CHECK(rates[0].points[0].low == doctest::Approx(2.5));
  CHECK(rates[0].points[0].high == doctest::Approx(10));
}

TEST_CASE("hits are the same by primitive or by distance to a few ulp") {
  CHECK(sameHit({1, 5}, {1, 5}, false));
  CHECK(sameHit({1, 5}, {std::nextafter(1.0f, 2.0f), 6}, false));
  CHECK(!sameHit({1, 5}, {1.00001f, 6}, false));
  CHECK(!sameHit({1, 5}, {1, missed}, false));
  CHECK(sameHit({1, missed}, {2, missed}, false));
  CHECK(sameHit({0, 5}, {2, 6}, true));
  CHECK(!sameHit({0, 5}, {2, missed}, true));
  CHECK(differentHits(std::vector<StreamHit>{{1, 5}}, std::vector<StreamHit>{}, false) == 1);
}

TEST_CASE("spread numbers are distinct, in range and as many as can be") {
  CHECK(spreadNumbers(10, 5) == std::vector<std::uint32_t>{0, 2, 4, 6, 8});
  CHECK(spreadNumbers(3, 100) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(spreadNumbers(7, 0) == std::vector<std::uint32_t>{0});
  CHECK(spreadNumbers(0, 5).empty());
}

TEST_CASE("gathers are the same by count and flux") {
  StreamGather const a{Rgb(1, 2, 3), 5, 1};
  CHECK(differentGathers(std::vector{a}, std::vector{a}) == 0);
  CHECK(differentGathers(std::vector{a}, std::vector{StreamGather{Rgb(1, 2, 3), 6, 1}}) == 1);
  CHECK(differentGathers(std::vector{a}, std::vector{StreamGather{Rgb(1, 2.01f, 3), 5, 1}}) == 1);
}

TEST_CASE("the k nearest are judged by every photon's distance") {
  StreamQuery const query{{0, 0, 0}, {0, 0, 1}};
  std::vector<StreamPhoton> photons;
  for (int i = 1; i <= 10; ++i) photons.push_back({{0.1f * float(i), 0, 0}, {0, 0, 1}, Rgb(1.0f)});
  photons.push_back({{0.01f, 0, 0}, {0, 0, -1}, Rgb(1.0f)});    // the other side of a wall
  photons.push_back({{0.01f, 0, 0.5f}, {0, 0, 1}, Rgb(1.0f)});  // above the disc
  CHECK(rightNearest({Rgb(2.0f), 3, 0.09f}, query, photons, 0.95f, 3));
  CHECK(!rightNearest({Rgb(2.0f), 3, 0.16f}, query, photons, 0.95f, 3));
  CHECK(!rightNearest({Rgb(2.0f), 2, 0.04f}, query, photons, 0.95f, 3));
  CHECK(rightNearest({Rgb(9.0f), 9, 0.95f * 0.95f}, query, photons, 0.95f, 50));
  CHECK(!rightNearest({Rgb(10.0f), 10, 0.95f * 0.95f}, query, photons, 0.95f, 50));
}

TEST_CASE("a traversal with one wrong hit is found out and given no time") {
  BenchOptions const options = quickOptions();
  BuiltScene const built = buildStructures(bumpySphereOf(300), options);
  auto const stream = makeRayStream(built.stream, options.scene.backend);
  auto const sets = tracedSets(built.stream, *stream, insideView, {32, 32}, {"primary", "shadow1"});
  REQUIRE(sets.size() == 2);
  LyingStream lying(*stream, Traversal::bvh);
  int liars = 0, honest = 0;
  for (const TimedTraversal& t : timeTraversals(built.stream, lying, sets[0], 1e4, options)) {
    BenchRow const row = t.row("series", "x", 1);
    if (t.traversal != Traversal::bvh) {
      ++honest;
      CHECK(!row.failed);
      CHECK(row.seconds.size() == 2);
      continue;
    }
    ++liars;
    CHECK(row.failed);
    CHECK(has(row.note, "FAILED: 1 of 1,024 hits differ"));
    CHECK(row.seconds.empty());
  }
  CHECK(liars == 1);
  CHECK(honest >= 3);
  CHECK(differentFromBrute(built.stream, sets[0], 1e6, options) == 0);
  RaySet wrong = sets[0];
  for (StreamHit& hit : wrong.hits) hit.primitive = missed;
  CHECK(differentFromBrute(built.stream, wrong, 1e4, options) == 64);  // no fewer rays than that
}

#ifdef ROPELIGHT_PROGRAM

TEST_CASE("what a benchmark cannot read or write is said before anything is measured") {
  TemporaryFolder const folder;
  putBytes(folder / "file", "");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"bench", "traversal", "--mesh", "missing.obj"},
        {"bench", "kdtree", "--out", "file"},
        {"bench", "kdtree", "--csv", "missing/rows.csv"}}) {
    Program program(ROPELIGHT_PROGRAM, arguments, folder.path());
    CHECK(program.exitCode() == 3);
    CHECK(has(program.err(), arguments.back()));
    CHECK(program.out().empty());
  }
}

#endif

TEST_CASE("brute force on part of the rays says so and is scaled") {
  BenchOptions const options = quickOptions();
  BuiltScene const built = buildStructures(bumpySphereOf(100), options);
  auto const stream = makeRayStream(built.stream, options.scene.backend);
  auto const sets = tracedSets(built.stream, *stream, insideView, {32, 32}, {"shadow1"});
  auto const timed = timeTraversals(built.stream, *stream, sets[0], 25600, options);
  REQUIRE(timed[0].traversal == Traversal::brute);
  CHECK(timed[0].rays == 256);
  CHECK(timed[0].of == 1024);
  BenchRow const row = timed[0].row("brute", "100", 100);
  CHECK(row.estimated);
  CHECK(row.note == "256 of 1,024 rays, time scaled");
  CHECK(!row.failed);
}

}  // namespace ropelight
