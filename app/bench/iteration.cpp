// One SPPM iteration at a time: what a frame of the viewer costs.

#include <fmt/format.h>

#include "app/arguments/scene_path.h"
#include "app/bench/bench.h"
#include "app/bench/results/stats.h"
#include "app/bench/results/timing.h"
#include "render/import/load.h"

namespace ropelight {
namespace {

constexpr const char* defaultScene = "box-spheres-diffuse";
constexpr int defaultSize = 512;                     // pixels
constexpr double defaultRadii[] = {0, .00665, .03};  // scene units; 0: from the scene

/// Timing stages on a GPU waits for each one, so that it has a run of its own.
std::map<std::string, double> stageTimes(const Scene& scene, const Settings& settings, const BenchOptions& options) {
  BackendChoice timed = options.scene.backend;
  timed.stageTimes = true;
  auto const integrator = makeIntegrator(scene, settings, timed);
  integrator->advance(warmUpRuns);
  integrator->reset();
  integrator->advance(options.repeat);
  return integrator->stats().stageSeconds;
}

void measure(const Scene& scene, const Settings& settings, const BenchOptions& options, BenchResult& result) {
  auto const integrator = makeIntegrator(scene, settings, options.scene.backend);
  integrator->advance(warmUpRuns);
  integrator->reset();
  std::vector<double> seconds;
  for (int i = 0; i < options.repeat; ++i) seconds.push_back(secondsOf([&] { integrator->advance(1); }));
  Stats stats = integrator->stats();
  if (stats.stageSeconds.empty()) stats.stageSeconds = stageTimes(scene, settings, options);
  BenchTable& table = result.tables.front();
  std::string const name = scene.name.empty() ? scene.file : scene.name;
  table.rows.push_back(statsRow("iteration", name, stats, std::move(seconds)));
  table.remarks.push_back(fmt::format("stages at {}, ms: {}", table.rows.back().x, stagesText(stats)));
  result.device = stats.device;
}

}  // namespace

/// Times single iterations, by default of box-spheres-diffuse at 512 x 512 with 262,144 photons at three first radii.
BenchResult benchIteration(const BenchOptions& options) {
  bool const ownScene = options.scene.scene.empty();
  Scene const scene = loadScene(findScene(ownScene ? defaultScene : options.scene.scene));
  Settings settings = options.scene.settings;
  if (ownScene && settings.width == 0) settings.width = defaultSize;
  if (ownScene && settings.height == 0) settings.height = defaultSize;
  BenchResult result = startResult("iteration", "", options, "");
  result.tables = {{"single iterations", "first radius", {}, {}}};
  if (!ownScene || settings.radius > 0) {
    measure(scene, settings, options, result);
    return result;
  }
  for (double const radius : defaultRadii) {
    settings.radius = radius;
    measure(scene, settings, options, result);
  }
  return result;
}

}  // namespace ropelight
