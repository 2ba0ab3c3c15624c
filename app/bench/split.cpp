// The kd-tree's builders against each other (paper, Figure 9).

#include <fmt/format.h>

#include <cmath>

#include "accel/kdtree/builder/build.h"
#include "app/bench/rays.h"
#include "app/bench/results/checks.h"
#include "app/bench/results/timing.h"
#include "measure/rays/meshes.h"

namespace ropelight {
namespace {

struct Builder {
  const char* name;
  KdSplit split;
};

constexpr Builder builders[] = {
    {"midpoint", KdSplit::midpoint}, {"SAH, binned", KdSplit::sah}, {"SAH, sweep", KdSplit::sweep}};
constexpr std::size_t builderCount = std::size(builders);
const std::vector<std::string> kinds = {"primary", "diffuse1"};

/// Seconds for all builds of one mesh, and for all runs on one set of rays.
double limitSeconds(const BenchOptions& options) { return fullSizes(options) ? 30 : 4; }

struct Trees {
  std::shared_ptr<const FlatScene> flat;
  std::shared_ptr<const KdTree> tree[builderCount];
};

BenchRow rowOf(const char* series, std::size_t triangles) {
  BenchRow row;
  row.series = series;
  row.x = fmt::format("{}", triangles);
  row.place = double(triangles);
  return row;
}

Trees timeBuilds(std::vector<FlatTriangle> triangles, const BenchOptions& options, BenchTable& table) {
  Trees trees;
  trees.flat = std::make_shared<const FlatScene>(triangleScene(std::move(triangles)));
  std::vector<Contender> contenders;
  for (std::size_t i = 0; i < builderCount; ++i)
    contenders.push_back(
        {[&trees, &options, i] {
           KdConfig config;
           config.split = builders[i].split;
           config.threads = options.scene.backend.threads;
           return secondsOf([&] { trees.tree[i] = std::make_shared<const KdTree>(buildKdTree(*trees.flat, config)); });
         },
         {}});
  timeInTurn(contenders, 1, options.repeat, limitSeconds(options));
  for (std::size_t i = 0; i < builderCount; ++i) {
    const KdTree& tree = *trees.tree[i];
    BenchRow row = rowOf(builders[i].name, trees.flat->triangles.size());
    row.seconds = contenders[i].seconds;
    row.value = tree.stats.sahCost;
    row.unit = "SAH cost";
    row.note = fmt::format(
        "{} references ({:.2f} a triangle), {} leaves of at most {}, depth {}, {:.1f} MiB, ropes {:.1f} ms, {} splits "
        "not made for want of memory",
        grouped(tree.references.size()), tree.stats.duplicates, grouped(tree.leaves.size()), tree.stats.largestLeaf,
        tree.stats.depth, double(tree.bytes()) / (1 << 20), 1e3 * tree.stats.ropeSeconds, tree.stats.budgetHits);
    table.rows.push_back(row);
  }
  return trees;
}

/// All trees on the same rays, those of the first tree; the hits must be the same, and brute force's.
void timeRays(const Trees& trees, const RayImage& image, const BenchOptions& options, std::span<BenchTable> tables,
              DeviceInfo& device) {
  std::unique_ptr<RayStream> streams[builderCount];
  for (std::size_t i = 0; i < builderCount; ++i)
    streams[i] =
        makeRayStream({.flat = trees.flat, .tree = trees.tree[i], .bvh = {}, .wide = {}}, options.scene.backend);
  device = streams[0]->device();
  auto const sets =
      tracedSets({.flat = trees.flat, .tree = {}, .bvh = {}, .wide = {}}, *streams[0], insideView, image, kinds);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    std::vector<Contender> contenders;
    std::vector<std::size_t> different;
    std::size_t const wrong = differentFromBrute({.flat = trees.flat, .tree = {}, .bvh = {}, .wide = {}}, sets[k],
                                                 bruteBudget(options) / 4, options);
    for (auto& stream : streams) {
      stream->setRays(sets[k].rays);
      contenders.push_back({[&stream] { return stream->trace(Traversal::ropes, false); }, {}});
      contenders.back().run();
      different.push_back(wrong + differentHits(stream->hits(), sets[k].hits, false));
    }
    timeInTurn(contenders, warmUpRuns - 1, options.repeat, limitSeconds(options));
    for (std::size_t i = 0; i < builderCount; ++i) {
      TimedTraversal const timed{Traversal::ropes, contenders[i].seconds, sets[k].rays.size(), sets[k].rays.size(),
                                 different[i]};
      std::size_t const triangles = trees.flat->triangles.size();
      tables[k].rows.push_back(timed.row(builders[i].name, fmt::format("{}", triangles), double(triangles)));
    }
  }
}

LinePlot plotOf(const BenchResult& result, const BenchTable& table, const char* title, const char* unit, Plotted what) {
  LinePlot plot;
  plot.title = title;
  plot.caption = result.caption();
  plot.x = {"triangles", true, {}};
  plot.y = {unit, what == Plotted::milliseconds, {}};
  plot.curves = curvesOf(table, what);
  return plot;
}

}  // namespace

/// Midpoint splits against the surface-area heuristic, binned and swept: build and trace (paper, Figure 9).
BenchResult benchSplit(const BenchOptions& options) {
  bool const full = fullSizes(options);
  RayImage const image = full ? RayImage{1920, 1080} : RayImage{256, 256};
  std::vector<BenchTable> tables = {{"builds, on the CPU", "triangles", {}, {}},
                                    {"primary rays", "triangles", {}, {}},
                                    {"first bounce", "triangles", {}, {}}};
  DeviceInfo device;
  for (int halfDecade = 4; halfDecade <= (full ? 12 : 10); ++halfDecade) {
    auto triangles = bumpySphereOf(std::uint32_t(std::lround(std::pow(10, halfDecade / 2.0))));
    normalise(triangles);
    Trees const trees = timeBuilds(std::move(triangles), options, tables[0]);
    timeRays(trees, image, options, std::span(tables).subspan(1), device);
  }
  BenchResult result = startResult(
      "split", device.name, options,
      fmt::format("bumpy sphere seen from inside, {} × {} rays, kd-tree with ropes", image.width, image.height));
  result.tables = std::move(tables);
  result.plots = {{"", plotOf(result, result.tables[0], "Building the kd-tree", "time (ms)", Plotted::milliseconds)},
                  {"primary", plotOf(result, result.tables[1], "Primary rays through the kd-tree", "rate (Mrays/s)",
                                     Plotted::value)},
                  {"bounce", plotOf(result, result.tables[2], "First bounce through the kd-tree", "rate (Mrays/s)",
                                    Plotted::value)}};
  return result;
}

}  // namespace ropelight
