#pragma once
// What the benchmarks of rays share: structures over a mesh, sets of rays, and traversals timed in turn.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/results/result.h"
#include "measure/rays/ray_sets.h"
#include "measure/streams/ray_stream.h"

namespace ropelight {

/// A kd-tree, the two BVHs and the seconds that each build of them took.
struct BuiltScene {
  StreamScene stream;
  std::vector<double> treeSeconds, bvhSeconds, widenSeconds;
};

/// What `build` returns, its seconds, done again up to five times or until three seconds are over.
std::vector<double> timeBuilds(const std::function<double()>& build);

BuiltScene buildStructures(std::vector<FlatTriangle> triangles, const BenchOptions& options);

/// All sets of an image's rays, traced by the first tree there is. `wanted`: names; their forerunners are made too.
std::vector<RaySet> tracedSets(const StreamScene& scene, RayStream& stream, const RayView& view, const RayImage& image,
                               const std::vector<std::string>& wanted);

/// The times of one traversal. Fails where hits differ from the set's; Embree's own triangle test may differ in a few.
struct TimedTraversal {
  Traversal traversal = Traversal::brute;
  std::vector<double> seconds;  ///< scaled to all rays where only `rays` were traced
  std::size_t rays = 0, of = 0;
  std::size_t different = 0;

  bool failed() const;
  std::string note() const;
  BenchRow row(const std::string& series, const std::string& x, double place) const;
};

/// Times the traversals that the stream supports, in turn; brute force on so many rays that a run tests at most
/// `bruteTests` triangles, from a stream of its own.
std::vector<TimedTraversal> timeTraversals(const StreamScene& scene, RayStream& stream, const RaySet& set,
                                           double bruteTests, const BenchOptions& options);

/// How many of the set's hits are not brute force's, of rays spread over the set, as above.
std::size_t differentFromBrute(const StreamScene& scene, const RaySet& set, double bruteTests,
                               const BenchOptions& options);

/// Triangle tests that brute force may make in one run.
double bruteBudget(const BenchOptions& options);

}  // namespace ropelight
