// Gathering photons by brute force, through the grid, and the k nearest (paper, Figure 7); building the grid.

#include <fmt/format.h>

#include <cmath>

#include "app/bench/rays.h"
#include "app/bench/results/checks.h"
#include "app/bench/results/timing.h"
#include "measure/streams/gather_stream.h"
#include "render/core/rng.h"

namespace ropelight {
namespace {

constexpr double wantedInside = 100;  // photons within the radius, on average
constexpr int nearest = 50;
constexpr std::size_t checkedNearest = 16;
constexpr std::uint32_t million = 1u << 20;

/// For all runs with one number of photons.
double limitSeconds(const BenchOptions& options) { return fullSizes(options) ? 8 : 4; }

/// Where gathers of one number of photons differ from each other.
struct Workload {
  std::vector<StreamPhoton> photons;
  std::vector<StreamQuery> queries;
  float radius;
};

/// (u, v) ∈ [0, 1]² on face 0…5 of the unit cube, with the face's outward normal.
void placeOnFace(std::uint32_t face, float u, float v, float (&position)[3], float (&normal)[3]) {
  std::uint32_t const axis = face % 3;
  for (float& n : normal) n = 0;
  normal[axis] = face < 3 ? -1.0f : 1.0f;
  position[axis] = face < 3 ? 0.0f : 1.0f;
  position[(axis + 1) % 3] = u;
  position[(axis + 2) % 3] = v;
}

Bounds unitCube() {
  Bounds bounds;
  bounds.grow(Vec3d(0.0));
  bounds.grow(Vec3d(1.0));
  return bounds;
}

std::vector<StreamPhoton> uniformPhotons(std::uint32_t count, std::uint64_t seed) {
  std::vector<StreamPhoton> photons(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    cpu::Uint4 const r = cpu::philox({i, 0, 0, 0}, std::uint32_t(seed), std::uint32_t(seed >> 32));
    placeOnFace(r.x % 6, cpu::toUnit(r.y), cpu::toUnit(r.z), photons[i].position, photons[i].normal);
    photons[i].flux = Rgb(1.0f);
  }
  return photons;
}

/// edge × edge points per face, at the middles of squares, in tiles of 8 × 4; edge is a multiple of 8.
std::vector<StreamQuery> tiledQueries(std::uint32_t edge) {
  std::vector<StreamQuery> queries(std::size_t(6) * edge * edge);
  for (std::uint32_t i = 0; i < queries.size(); ++i) {
    std::uint32_t const k = i % (edge * edge), tile = k / 32, lane = k % 32, across = edge / 8;
    std::uint32_t const x = 8 * (tile % across) + (lane & 7), y = 4 * (tile / across) + (lane >> 3);
    placeOnFace(i / (edge * edge), (float(x) + 0.5f) / float(edge), (float(y) + 0.5f) / float(edge),
                queries[i].position, queries[i].normal);
  }
  return queries;
}

/// The radius of discs that hold so many of the photons, away from edges.
float radiusFor(double inside, std::size_t photons) { return float(std::sqrt(6 * inside / (M_PI * double(photons)))); }

BenchRow rowOf(const std::string& series, std::size_t photons) {
  BenchRow row;
  row.series = series;
  row.x = fmt::format("{}", photons);
  row.place = double(photons);
  return row;
}

void fail(BenchRow& row, std::size_t wrong, std::size_t checked) {
  if (wrong == 0) return;
  row.failed = true;
  row.seconds.clear();
  row.value = noValue;
  row.note = fmt::format("FAILED: {} of {} gathers differ from brute force", grouped(wrong), grouped(checked));
}

/// Times brute force on part of the queries, the grid and the k nearest in turn; checks them all against brute force.
class GatherTimer {
 public:
  GatherTimer(const Workload& work, const BenchOptions& options)
      : work_(work),
        options_(options),
        numbers_(spreadNumbers(work.queries.size(),
                               std::size_t(std::max(64.0, bruteBudget(options) / double(work.photons.size()))))),
        grid_(makeGatherStream(options.scene.backend)),
        brute_(makeGatherStream(options.scene.backend)) {
    grid_->setPhotons(work.photons, unitCube());
    grid_->setQueries(work.queries);
    grid_->build(work.radius);
    brute_->setPhotons(work.photons, unitCube());
    brute_->setQueries(pick<StreamQuery>(work.queries, numbers_));
    brute_->gather(GatherKind::brute, work.radius, nearest);
    expected_ = brute_->results();
  }

  DeviceInfo device() const { return grid_->device(); }

  /// One row each: brute force, grid, k nearest.
  std::vector<BenchRow> run() {
    std::vector<BenchRow> rows = {rowOf("brute force", work_.photons.size()), rowOf("grid", work_.photons.size()),
                                  rowOf(fmt::format("grid, {} nearest", nearest), work_.photons.size())};
    std::size_t const wrong[] = {0, wrongInRadius(), wrongNearest()};
    Contender contenders[] = {{[this] { return brute_->gather(GatherKind::brute, work_.radius, nearest); }, {}},
                              {[this] { return grid_->gather(GatherKind::grid, work_.radius, nearest); }, {}},
                              {[this] { return grid_->gather(GatherKind::nearest, work_.radius, nearest); }, {}}};
    timeInTurn(contenders, warmUpRuns, options_.repeat, limitSeconds(options_));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].seconds = contenders[i].seconds;
      if (i == 0) scaleBrute(rows[i]);
      rows[i].setRate(double(work_.queries.size()), "queries");
      fail(rows[i], wrong[i], i == 2 ? checkedNearest : numbers_.size());
    }
    return rows;
  }

 private:
  void scaleBrute(BenchRow& row) const {
    if (numbers_.size() == work_.queries.size()) return;
    for (double& s : row.seconds) s *= double(work_.queries.size()) / double(numbers_.size());
    row.estimated = true;
    row.note = fmt::format("{} of {} queries, time scaled", grouped(numbers_.size()), grouped(work_.queries.size()));
  }

  std::size_t wrongInRadius() {
    grid_->gather(GatherKind::grid, work_.radius, nearest);
    return differentGathers(pick<StreamGather>(grid_->results(), numbers_), expected_);
  }

  /// Every photon carries one watt; with k found, the farthest gives the radius alone.
  static bool rightFlux(const StreamGather& gather) {
    return gather.flux == Rgb(float(gather.count == nearest ? nearest - 1 : gather.count));
  }

  std::size_t wrongNearest() {
    grid_->gather(GatherKind::nearest, work_.radius, nearest);
    auto const found = grid_->results();
    std::size_t wrong = 0;
    for (std::uint32_t const i : spreadNumbers(work_.queries.size(), checkedNearest))
      if (!rightNearest(found[i], work_.queries[i], work_.photons, work_.radius, nearest) || !rightFlux(found[i]))
        ++wrong;
    return wrong;
  }

  const Workload& work_;
  const BenchOptions& options_;
  std::vector<std::uint32_t> numbers_;
  std::unique_ptr<GatherStream> grid_, brute_;
  std::vector<StreamGather> expected_;
};

constexpr std::size_t checkedStandard = 1024;

/// How many gathers through the grid as it was built last differ from testing every photon, on queries spread over all.
std::size_t wrongGathers(GatherStream& stream, const std::vector<StreamQuery>& queries, float radius) {
  auto const numbers = spreadNumbers(queries.size(), checkedStandard);
  stream.gather(GatherKind::grid, radius, nearest);
  auto const found = pick<StreamGather>(stream.results(), numbers);
  stream.setQueries(pick<StreamQuery>(queries, numbers));
  stream.gather(GatherKind::brute, radius, nearest);
  auto const expected = stream.results();
  stream.setQueries(queries);
  return differentGathers(found, expected);
}

/// Builds and gathers with 2²⁰ photons and multiples of it; cells as wide as the radius.
void addStandardRows(std::vector<StreamQuery> queries, const BenchOptions& options, bool full, BenchTable& builds,
                     BenchTable& gathers) {
  for (std::uint32_t const millions : {1u, 4u, 16u}) {
    if (millions > 1 && !full) continue;
    std::size_t const count = std::size_t(millions) * million;
    auto const stream = makeGatherStream(options.scene.backend);
    stream->setPhotons(uniformPhotons(std::uint32_t(count), options.scene.settings.seed), unitCube());
    stream->setQueries(queries);
    auto const time = [&](BenchTable& table, const std::string& series, const char* what, auto run) {
      Contender contender{run, {}};
      timeInTurn({&contender, 1}, warmUpRuns, options.repeat, limitSeconds(options) / 4);
      BenchRow row = rowOf(series, count);
      row.seconds = contender.seconds;
      row.setRate(double(table.name == builds.name ? count : queries.size()), what);
      table.rows.push_back(row);
    };
    float const wide = radiusFor(100, count);
    time(builds, "build, at most 2²⁰ cells", "photons", [&] { return stream->build(wide, million); });
    fail(builds.rows.back(), wrongGathers(*stream, queries, wide), checkedStandard);
    time(builds, "build, as the renderer has it", "photons", [&] { return stream->build(wide); });
    fail(builds.rows.back(), wrongGathers(*stream, queries, wide), checkedStandard);
    if (millions > 4) continue;
    for (int const inside : {20, 100}) {
      float const radius = radiusFor(inside, count);
      stream->build(radius, full ? 1u << 26 : 0);
      time(gathers, fmt::format("grid of all cells, k = {} on average", inside), "queries",
           [&] { return stream->gather(GatherKind::grid, radius, nearest); });
      fail(gathers.rows.back(), wrongGathers(*stream, queries, radius), checkedStandard);
      stream->build(radius);
      time(gathers, fmt::format("grid, k = {} on average", inside), "queries",
           [&] { return stream->gather(GatherKind::grid, radius, nearest); });
      fail(gathers.rows.back(), wrongGathers(*stream, queries, radius), checkedStandard);
    }
    if (millions > 1) continue;
    time(gathers, fmt::format("grid, {} nearest", nearest), "queries",
         [&] { return stream->gather(GatherKind::nearest, wide, nearest); });
  }
}

}  // namespace

/// Gathering 10³ to 10⁷ photons by brute force, grid and k nearest (paper, Figure 7), and building the grid.
BenchResult benchGather(const BenchOptions& options) {
  bool const full = fullSizes(options), gpu = chooseBackend(options.scene.backend).cuda;
  auto const queries = tiledQueries(gpu ? 592 : options.full ? 208 : 104);
  BenchResult result;
  BenchTable figure{"gather time against photons", "photons", {}, {}};
  for (int halfDecade = 6; halfDecade <= (full ? 14 : 12); ++halfDecade) {
    auto const count = std::uint32_t(std::lround(std::pow(10, halfDecade / 2.0)));
    Workload const work{uniformPhotons(count, options.scene.settings.seed), queries, radiusFor(wantedInside, count)};
    GatherTimer timer(work, options);
    if (result.bench.empty())
      result = startResult("gather", timer.device().name, options,
                           fmt::format("photons uniform on the faces of a unit cube, {} queries there in 8 × 4 tiles, "
                                       "radius for {} photons on average, k = {}",
                                       grouped(queries.size()), wantedInside, nearest));
    for (BenchRow& row : timer.run()) figure.rows.push_back(std::move(row));
  }
  BenchTable builds{"building the grid", "photons", {}, {}}, gathers{"gathers", "photons", {}, {}};
  addStandardRows(queries, options, full, builds, gathers);
  LinePlot plot;
  plot.title = "Gather time against photons";
  plot.caption = result.caption() + "; hollow: part of the queries, time scaled";
  plot.x = {"photons", true, {}};
  plot.y = {"time (ms)", true, {}};
  plot.curves = curvesOf(figure, Plotted::milliseconds);
  result.tables = {figure, builds, gathers};
  result.plots = {{"", plot}};
  return result;
}

}  // namespace ropelight
