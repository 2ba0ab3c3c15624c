// Every traversal on every kind of rays.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/bench/rays.h"
#include "measure/rays/meshes.h"
#include "measure/streams/bvh_embree.h"
#include "render/backend/devices.h"

namespace ropelight {
namespace {

const std::vector<std::string> kinds = {"primary", "diffuse1", "shadow1", "diffuse2", "photon1"};

struct Subject {
  std::string name;
  std::vector<FlatTriangle> triangles;
  RayView view;
};

Subject bumpy(const std::string& name, int segments, int rows, const RayView& view) {
  return {name, bumpySphere(segments, rows), view};
}

std::vector<Subject> subjects(const BenchOptions& options, bool full) {
  int const segments = full ? 1001 : 318, rows = full ? 501 : 159;
  std::string const name = full ? "bumpy1M" : "bumpy100k";
  std::vector<Subject> all = {bumpy(name + ":in", segments, rows, insideView),
                              bumpy(name, segments, rows, outsideView)};
  if (options.mesh.empty())
    all.push_back(bumpy("bumpy5k", 69, 38, outsideView));
  else
    all.push_back({std::filesystem::path(options.mesh).stem().string(), objTriangles(options.mesh), outsideView});
  for (Subject& subject : all) {
    normalise(subject.triangles);
    appendRoom(subject.triangles);
  }
  return all;
}

LinePlot plotOf(const BenchResult& result, const BenchTable& table) {
  LinePlot plot;
  plot.title = fmt::format("Traversals, {}", table.name);
  plot.caption = result.caption();
  plot.x = {"rays", false, kinds};
  plot.y = {"rate (Mrays/s)", false, {}};
  plot.curves = curvesOf(table, Plotted::value);
  std::erase_if(plot.curves, [](const Curve& curve) { return curve.name == traversals[0].name; });
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    plot.curves[i].connected = false;
    for (CurvePoint& p : plot.curves[i].points) p.x += 0.09 * (double(i) - 0.5 * double(plot.curves.size() - 1));
  }
  return plot;
}

void addBuilds(BenchTable& table, const std::string& mesh, const BuiltScene& built, int threads) {
  auto const add = [&](const char* series, std::vector<double> seconds, std::size_t bytes) {
    BenchRow row;
    row.series = series;
    row.x = mesh;
    row.seconds = std::move(seconds);
    if (bytes > 0) {
      row.value = double(bytes) / (1 << 20);
      row.unit = "MiB";
    }
    table.rows.push_back(row);
  };
  add("kd-tree, binned SAH", built.treeSeconds, built.stream.tree->bytes());
  add("BVH, 2 children", built.bvhSeconds, built.stream.bvh->bytes());
  add("BVH, 4 children, from the one of 2", built.widenSeconds, built.stream.wide->bytes());
  if (!EmbreeScene::supported()) return;
  add("Embree, robust", timeBuilds([&] { return EmbreeScene(*built.stream.flat, true, threads).buildSeconds(); }), 0);
}

BenchTable timeSubject(const Subject& subject, const BuiltScene& built, RayStream& stream, const RayImage& image,
                       const BenchOptions& options) {
  BenchTable table{
      fmt::format("{}, {} triangles", subject.name, grouped(built.stream.flat->triangles.size())), "rays", {}, {}};
  auto const sets = tracedSets(built.stream, stream, subject.view, image, kinds);
  for (std::size_t k = 0; k < sets.size(); ++k)
    for (const TimedTraversal& t : timeTraversals(built.stream, stream, sets[k], bruteBudget(options) / 4, options))
      table.rows.push_back(t.row(traversals[std::size_t(t.traversal)].name, sets[k].name, double(k)));
  return table;
}

/// The file of a subject's plot.
std::string suffixOf(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '-');
  return name;
}

}  // namespace

/// Every traversal on primary, diffuse, shadow and photon rays.
BenchResult benchTraversal(const BenchOptions& options) {
  bool const full = fullSizes(options);
  bool const cuda = chooseBackend(options.scene.backend).cuda;
  RayImage const image = cuda ? RayImage{1920, 1080} : full ? RayImage{640, 360} : RayImage{240, 136};
  BenchResult result;
  std::vector<BenchTable> tables;
  std::vector<std::string> suffixes;
  BenchTable builds{"builds, on the CPU", "mesh", {}, {}};
  for (Subject& subject : subjects(options, full)) {
    BuiltScene const built = buildStructures(std::move(subject.triangles), options);
    auto const stream = makeRayStream(built.stream, options.scene.backend);
    if (result.bench.empty())
      result = startResult(
          "traversal", stream->device().name, options,
          fmt::format("{} × {} rays a set in 8 × 4 tiles, meshes in a closed room", image.width, image.height));
    tables.push_back(timeSubject(subject, built, *stream, image, options));
    suffixes.push_back(suffixOf(subject.name));
    addBuilds(builds, subject.name, built, options.scene.backend.threads);
  }
  for (std::size_t i = 0; i < tables.size(); ++i)
    result.plots.push_back({i == 0 ? "" : suffixes[i], plotOf(result, tables[i])});
  tables.push_back(builds);
  result.tables = std::move(tables);
  return result;
}

}  // namespace ropelight
