// What showing a frame costs.

#include <GL/glew.h>
#include <fmt/format.h>

#include <chrono>

#include "app/bench.h"
#include "app/scene_path.h"
#include "app/view/panel.h"
#include "app/view/picture.h"
#include "app/view/window.h"
#include "render/backend/devices.h"
#include "render/scene/load.h"

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

BenchRow measure(Renderer& renderer, const Size& size, int gpu, bool interop, int repeat) {
  Picture picture(gpu, interop);
  ViewState const state;
  for (int i = 0; i < warmUp; ++i) showFrame(renderer, picture, size, state);
  BenchRow row;
  for (int i = 0; i < repeat; ++i) row.seconds.push_back(showFrame(renderer, picture, size, state));
  row.bench = "display";
  row.timed = picture.describePath().substr(0, picture.describePath().find(':'));
  DisplayTimes const times = picture.times();
  row.stats = renderer.status(estimateA).stats;
  row.stats.stageSeconds = {{"resolve", renderer.status(estimateA).presentSeconds * double(row.stats.iterations)},
                            {"upload, GPU", times.upload * 1e-3 * double(row.stats.iterations)},
                            {"draw, GPU", times.draw * 1e-3 * double(row.stats.iterations)},
                            {"both, CPU", times.cpu * 1e-3 * double(row.stats.iterations)}};
  row.settings = row.stats.settings;
  return row;
}

}  // namespace

std::vector<BenchRow> benchDisplay(const BenchOptions& options) {
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
  std::vector<BenchRow> rows;
  for (bool const interop : {true, false}) {
    if (interop && gpu < 0) continue;  // there is nothing to share
    rows.push_back(measure(renderer, window.framebufferSize(), gpu, interop, options.repeat));
    rows.back().scene = scene->file;
  }
  return rows;
}

}  // namespace ropelight
