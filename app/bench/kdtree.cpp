// Tree against brute force as the triangles grow (paper, Figure 8).

#include <fmt/format.h>

#include <cmath>

#include "app/bench/rays.h"
#include "measure/rays/meshes.h"

namespace ropelight {
namespace {

struct RayKind {
  const char* set;
  const char* table;
  const char* suffix;
};

constexpr RayKind kinds[] = {{"primary", "primary rays", ""}, {"diffuse1", "first bounce", "bounce"}};

LinePlot plotOf(const BenchResult& result, const BenchTable& table) {
  LinePlot plot;
  plot.title = fmt::format("Tree against brute force, {}", table.name);
  plot.caption = result.caption() + "; hollow: part of the rays, time scaled";
  plot.x = {"triangles", true, {}};
  plot.y = {"time (ms)", true, {}};
  plot.curves = curvesOf(table, Plotted::milliseconds);
  return plot;
}

}  // namespace

/// Rays against 10 to 10⁶ triangles by brute force and through trees (paper, Figure 8).
BenchResult benchKdTree(const BenchOptions& options) {
  bool const full = fullSizes(options);
  int const edge = full ? 512 : 256;
  BenchResult result;
  for (const RayKind& kind : kinds) result.tables.push_back({kind.table, "triangles", {}, {}});
  for (int halfDecade = 2; halfDecade <= (full ? 12 : 10); ++halfDecade) {
    auto triangles = bumpySphereOf(std::uint32_t(std::lround(std::pow(10, halfDecade / 2.0))));
    normalise(triangles);
    std::size_t const count = triangles.size();
    BuiltScene const built = buildStructures(std::move(triangles), options);
    auto const stream = makeRayStream(built.stream, options.scene.backend);
    auto const sets = tracedSets(built.stream, *stream, insideView, {edge, edge}, {kinds[0].set, kinds[1].set});
    for (std::size_t k = 0; k < sets.size(); ++k)
      for (const TimedTraversal& t : timeTraversals(built.stream, *stream, sets[k], bruteBudget(options), options))
        result.tables[k].rows.push_back(
            t.row(traversals[std::size_t(t.traversal)].name, fmt::format("{}", count), double(count)));
    if (result.bench.empty()) {
      auto tables = std::move(result.tables);
      result = startResult("kdtree", stream->device().name, options,
                           fmt::format("bumpy sphere seen from inside, {0} × {0} rays", edge));
      result.tables = std::move(tables);
    }
  }
  for (std::size_t k = 0; k < result.tables.size(); ++k)
    result.plots.push_back({kinds[k].suffix, plotOf(result, result.tables[k])});
  return result;
}

}  // namespace ropelight
