// One SPPM iteration at a time: what a frame of the viewer costs.

#include <chrono>

#include "app/bench.h"
#include "app/report.h"
#include "app/scene_path.h"
#include "render/scene/load.h"

namespace ropelight {
namespace {

constexpr int warmUp = 3;
constexpr const char* defaultScene = "box-spheres-diffuse";
constexpr int defaultSize = 512;                     // pixels
constexpr double defaultRadii[] = {0, .00665, .03};  // scene units; 0: from the scene

double timeIteration(Integrator& integrator) {
  auto const start = std::chrono::steady_clock::now();
  integrator.advance(1);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Timing stages on a GPU waits for each one, so that it has a run of its own.
std::map<std::string, double> stageTimes(const Scene& scene, const Settings& settings, const BenchOptions& options) {
  BackendChoice timed = options.scene.backend;
  timed.stageTimes = true;
  auto const integrator = makeIntegrator(scene, settings, timed);
  integrator->advance(warmUp);
  integrator->reset();
  integrator->advance(options.repeat);
  return integrator->stats().stageSeconds;
}

BenchRow measure(const Scene& scene, const Settings& settings, const BenchOptions& options) {
  auto const integrator = makeIntegrator(scene, settings, options.scene.backend);
  integrator->advance(warmUp);
  integrator->reset();
  BenchRow row;
  for (int i = 0; i < options.repeat; ++i) row.seconds.push_back(timeIteration(*integrator));
  row.bench = "iteration";
  row.scene = scene.name.empty() ? scene.file : scene.name;
  row.stats = integrator->stats();
  if (row.stats.stageSeconds.empty()) row.stats.stageSeconds = stageTimes(scene, settings, options);
  row.settings = row.stats.settings;
  row.threads = options.scene.backend.threads;
  return row;
}

}  // namespace

std::vector<BenchRow> benchIteration(const BenchOptions& options) {
  bool const ownScene = options.scene.scene.empty();
  Scene const scene = loadScene(findScene(ownScene ? defaultScene : options.scene.scene));
  Settings settings = options.scene.settings;
  if (ownScene && settings.width == 0) settings.width = defaultSize;
  if (ownScene && settings.height == 0) settings.height = defaultSize;
  if (!ownScene || settings.radius > 0) return {measure(scene, settings, options)};
  std::vector<BenchRow> rows;
  for (double const radius : defaultRadii) {
    settings.radius = radius;
    rows.push_back(measure(scene, settings, options));
  }
  return rows;
}

}  // namespace ropelight
