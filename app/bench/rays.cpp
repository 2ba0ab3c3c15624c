#include "app/bench/rays.h"

#include <fmt/format.h>

#include <algorithm>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "app/bench/results/checks.h"
#include "app/bench/results/timing.h"
#include "measure/rays/meshes.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

constexpr double embreeDifferences = 1e-3;  // share of the rays

constexpr std::size_t mostBuilds = 5;
constexpr double buildLimitSeconds = 3;

/// For all runs on one set of rays.
double limitSeconds(const BenchOptions& options) { return chooseBackend(options.scene.backend).cuda ? 10 : 4; }

/// On the CPU these are the plain ones.
bool forGpu(Traversal t) { return t == Traversal::ropesShared || t == Traversal::bvhRefill; }

Traversal firstTree(const RayStream& stream) {
  for (const TraversalInfo& t : traversals)
    if (t.id != Traversal::brute && t.id != Traversal::embree && stream.supports(t.id)) return t.id;
  return Traversal::brute;
}

std::vector<std::uint32_t> bruteNumbers(const StreamScene& scene, const RaySet& set, double tests) {
  double const triangles = std::max<double>(1, scene.flat->primitiveCount());
  return spreadNumbers(set.rays.size(), std::size_t(std::clamp(tests / triangles, 64.0, 4e9)));
}

/// Seconds of a part as if of the whole.
std::vector<double> scaled(std::vector<double> seconds, std::size_t part, std::size_t whole) {
  for (double& s : seconds) s *= double(whole) / double(part);
  return seconds;
}

}  // namespace

std::vector<double> timeBuilds(const std::function<double()>& build) {
  std::vector<double> seconds;
  double all = 0;
  while (seconds.size() < mostBuilds && all < buildLimitSeconds) {
    seconds.push_back(build());
    all += seconds.back();
  }
  return seconds;
}

BuiltScene buildStructures(std::vector<FlatTriangle> triangles, const BenchOptions& options) {
  BuiltScene built;
  auto const flat = std::make_shared<const FlatScene>(triangleScene(std::move(triangles)));
  built.stream.flat = flat;
  KdConfig tree;
  BvhConfig bvh;
  tree.threads = bvh.threads = options.scene.backend.threads;
  built.treeSeconds = timeBuilds(
      [&] { return secondsOf([&] { built.stream.tree = std::make_shared<const KdTree>(buildKdTree(*flat, tree)); }); });
  built.bvhSeconds = timeBuilds(
      [&] { return secondsOf([&] { built.stream.bvh = std::make_shared<const Bvh<2>>(buildBvh(*flat, bvh)); }); });
  built.widenSeconds = timeBuilds(
      [&] { return secondsOf([&] { built.stream.wide = std::make_shared<const Bvh<4>>(widen(*built.stream.bvh)); }); });
  return built;
}

std::vector<RaySet> tracedSets(const StreamScene& scene, RayStream& stream, const RayView& view, const RayImage& image,
                               const std::vector<std::string>& wanted) {
  Traversal const tree = firstTree(stream);
  auto const trace = [&](std::span<const StreamRay> rays) {
    stream.setRays(rays);
    stream.trace(tree, false);
    return stream.hits();
  };
  std::vector<RaySet> sets = makeRaySets(*scene.flat, view, image, trace);
  std::erase_if(sets,
                [&](const RaySet& set) { return std::find(wanted.begin(), wanted.end(), set.name) == wanted.end(); });
  return sets;
}

bool TimedTraversal::failed() const {
  return double(different) > (traversal == Traversal::embree ? embreeDifferences * double(of) : 0.0);
}

std::string TimedTraversal::note() const {
  std::string note;
  if (rays < of) note = fmt::format("{} of {} rays, time scaled", grouped(rays), grouped(of));
  if (different == 0) return note;
  return note + fmt::format("{}{}{} of {} hits differ", note.empty() ? "" : "; ", failed() ? "FAILED: " : "",
                            grouped(different), grouped(rays));
}

BenchRow TimedTraversal::row(const std::string& series, const std::string& x, double place) const {
  BenchRow row;
  row.series = series;
  row.x = x;
  row.place = place;
  row.note = note();
  row.failed = failed();
  row.estimated = rays < of;
  if (row.failed) return row;
  row.seconds = seconds;
  row.setRate(double(of), "rays");
  return row;
}

std::vector<TimedTraversal> timeTraversals(const StreamScene& scene, RayStream& stream, const RaySet& set,
                                           double bruteTests, const BenchOptions& options) {
  auto const numbers = bruteNumbers(scene, set, bruteTests);
  auto const bruteStream =
      makeRayStream({.flat = scene.flat, .tree = {}, .bvh = {}, .wide = {}}, options.scene.backend);
  bruteStream->setRays(pick<StreamRay>(set.rays, numbers));
  stream.setRays(set.rays);
  bool const cpu = stream.device().backend == BackendKind::cpu;
  std::vector<TimedTraversal> timed;
  std::vector<Contender> contenders;
  for (const TraversalInfo& info : traversals) {
    bool const brute = info.id == Traversal::brute;
    RayStream& on = brute ? *bruteStream : stream;
    if (!on.supports(info.id) || (cpu && forGpu(info.id))) continue;
    contenders.push_back({[&on, &info, &set] { return on.trace(info.id, set.anyHit); }, {}});
    contenders.back().run();
    auto const expected = brute ? pick<StreamHit>(set.hits, numbers) : set.hits;
    timed.push_back({info.id, {}, expected.size(), set.rays.size(), differentHits(on.hits(), expected, set.anyHit)});
  }
  // The set's hits are the first tree's, so that what brute force contradicts is an error of that tree.
  for (TimedTraversal& t : timed)
    if (t.traversal == Traversal::ropes && timed[0].traversal == Traversal::brute) t.different += timed[0].different;
  timeInTurn(contenders, warmUpRuns - 1, options.repeat, limitSeconds(options));
  for (std::size_t i = 0; i < timed.size(); ++i)
    timed[i].seconds = scaled(contenders[i].seconds, timed[i].rays, timed[i].of);
  return timed;
}

std::size_t differentFromBrute(const StreamScene& scene, const RaySet& set, double bruteTests,
                               const BenchOptions& options) {
  auto const numbers = bruteNumbers(scene, set, bruteTests);
  auto const stream = makeRayStream({.flat = scene.flat, .tree = {}, .bvh = {}, .wide = {}}, options.scene.backend);
  stream->setRays(pick<StreamRay>(set.rays, numbers));
  stream->trace(Traversal::brute, set.anyHit);
  return differentHits(stream->hits(), pick<StreamHit>(set.hits, numbers), set.anyHit);
}

double bruteBudget(const BenchOptions& options) {
  if (chooseBackend(options.scene.backend).cuda) return 1e12;
  return options.full ? 1e8 : 2e7;
}

}  // namespace ropelight
