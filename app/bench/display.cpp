// What showing a frame costs.

#include <GL/glew.h>
#include <fmt/format.h>

#include <chrono>

#include "app/arguments/scene_path.h"
#include "app/bench/bench.h"
#include "app/bench/results/stats.h"
#include "app/viewer/draw/picture.h"
#include "app/viewer/gl/window.h"
#include "app/viewer/panel/panel.h"
#include "render/backend/devices.h"
#include "render/import/load.h"

namespace ropelight {
namespace {

using namespace view;

constexpr int warmUp = 10;
constexpr Size defaultSize{1920, 1080};

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds to show the film once, after an iteration that is not in them.
double showFrame(Renderer& renderer, Picture& picture, const Size& size, const ViewState& state) {
  renderer.step(1);
  renderer.finishSteps();
  std::array<EstimateStatus, 3> estimates;
  for (int k = 0; k < 3; ++k) estimates[std::size_t(k)] = renderer.status(k);
  glFinish();
  auto const start = std::chrono::steady_clock::now();
  picture.update(renderer, estimates, {}, state);
  picture.draw({0, 0, size.width, size.height}, size.height, state, 0);
  glFinish();
  return estimates[estimateA].presentSeconds + secondsSince(start);
}

void measure(Renderer& renderer, const Size& size, int gpu, bool interop, const std::string& scene, int repeat,
             BenchResult& result) {
  Picture picture(gpu, interop);
  ViewState const state;
  for (int i = 0; i < warmUp; ++i) showFrame(renderer, picture, size, state);
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) seconds.push_back(showFrame(renderer, picture, size, state));
  DisplayTimes const times = picture.times();
  Stats stats = renderer.status(estimateA).stats;
  double const iterations = double(stats.iterations);
  stats.stageSeconds = {{"resolve", renderer.status(estimateA).presentSeconds * iterations},
                        {"upload, GPU", times.upload * 1e-3 * iterations},
                        {"draw, GPU", times.draw * 1e-3 * iterations},
                        {"both, CPU", times.cpu * 1e-3 * iterations}};
  std::string const way = picture.describePath().substr(0, picture.describePath().find(':'));
  result.tables.front().rows.push_back(statsRow(way, scene, stats, std::move(seconds)));
  result.tables.front().remarks.push_back(fmt::format("parts of {}, ms: {}", way, stagesText(stats)));
  result.device = stats.device;
}

}  // namespace

/// Times what a window's frame costs beyond the iteration, by every way that the pixels can go, by default at
/// 1920 x 1080: pixels into GL, the display pass, and waiting for the GPU; no panel and no buffer swap. Opens a window.
BenchResult benchDisplay(const BenchOptions& options) {
  Settings settings = options.scene.settings;
  if (settings.width == 0) settings.width = defaultSize.width;
  if (settings.height == 0) settings.height = defaultSize.height;
  std::string const file = findScene(options.scene.scene.empty() ? "cornell" : options.scene.scene);
  auto const scene = std::make_shared<const Scene>(loadScene(file));
  Window window("ropelight: display", settings.width, settings.height);
  window.setVsync(false);
  ChosenBackend const chosen = chooseBackend(options.scene.backend);
  int const gpu = chosen.cuda ? chosen.gpu : -1;
  Renderer renderer(options.scene.backend, true);
  renderer.setSettings(estimateA, settings);
  renderer.setScene(scene, scene->camera);
  BenchResult result =
      startResult("display", "", options, fmt::format("{} × {} pixels", settings.width, settings.height));
  result.tables = {{"showing a frame", "first radius", {}, {}}};
  for (bool const interop : {true, false}) {
    if (interop && gpu < 0) continue;  // there is nothing to share
    measure(renderer, window.framebufferSize(), gpu, interop, scene->file, options.repeat, result);
  }
  return result;
}

}  // namespace ropelight
