#include "app/commands/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <functional>

#include "app/arguments/scene_path.h"
#include "app/run/accumulate.h"
#include "app/run/output.h"
#include "app/run/report.h"
#include "app/run/standard_streams.h"
#include "app/run/version.h"
#include "render/core/error.h"
#include "render/image_files/image_file.h"
#include "render/import/load.h"

namespace ropelight {
namespace {

constexpr std::uint64_t defaultIterations = 64;

/// Everything that can be known to fail before any time is spent. inputs: as far as they are known yet.
void checkOutputs(const RenderOptions& options, const std::vector<std::string>& inputs) {
  for (const std::string& path : options.outputs) {
    try {
      imageFormatOf(path);
    } catch (const Error&) {
      throw Error(fmt::format("{}: an image file ends in .png or .exr; name it so", path), ExitCode::usage);
    }
  }
  std::vector<std::string> outputs = options.outputs;
  outputs.push_back(options.json);
  requireOutputs(outputs, inputs);
}

void writeOutput(const std::string& path, const Image& image, const Metadata& metadata, bool quiet) {
  ShareProgress progress("writing " + path, quiet);
  writeImage(path, image, {}, metadata, [&](double share) { progress.update(share); });
}

nlohmann::ordered_json statistics(const RenderOptions& options, const Scene& scene, const Settings& settings,
                                  const Stats& stats, const Accumulated& run) {
  return {{"version", version},
          {"scene", scene.file},
          {"notes", scene.notes},
          {"outputs", options.outputs},
          {"wallSeconds", run.seconds},
          {"interrupted", run.interrupted},
          {"iterationsPerSecond", iterationRate(stats)},
          {"megaRays", megaRays(stats)},
          {"megaPhotons", megaPhotons(stats)},
          {"settings", toJson(settings)},
          {"stats", toJson(stats)}};
}

void writeOutputs(const RenderOptions& options, const Scene& scene, const Integrator& integrator,
                  const Accumulated& run) {
  Stats const stats = integrator.stats();
  Image const film = integrator.film();
  Metadata const metadata = imageMetadata(stats.settings, scene, stats);
  std::vector<std::function<void()>> writers;
  for (const std::string& path : options.outputs)
    writers.push_back([&] { writeOutput(path, film, metadata, options.quiet); });
  if (!options.json.empty())
    writers.push_back([&] { writeJson(options.json, statistics(options, scene, stats.settings, stats, run)); });
  writeAll(writers);
}

void printSummary(const RenderOptions& options, const Stats& stats, const Accumulated& run) {
  printTo(options.json == "-" ? stderr : stdout,
          "{} iterations in {:.2f} s: {:.3g} it/s, {:.3g} Mrays/s, {:.3g} Mphotons/s on {}; wrote {}\n",
          stats.iterations, run.seconds, iterationRate(stats), megaRays(stats), megaPhotons(stats), stats.device,
          fmt::join(options.outputs, ", "));
}

void printNotes(const Stats& stats) {
  if (stats.regrown > 0)
    printError("note: photons were traced again {} times after their storage had grown", stats.regrown);
  if (stats.chunks > 1) printError("note: each iteration's photons were traced in {} parts", stats.chunks);
}

/// What makes the image wrong is reported even with --quiet.
void printWarnings(const Stats& stats) {
  if (stats.nonFinite > 0)
    printError("warning: {} samples were NaN or infinite and were left out of the image ({})", stats.nonFinite,
               nonFiniteStages(stats));
  if (stats.truncatedPaths > 0)
    printError("warning: {} paths were cut at {} edges; their light is missing", stats.truncatedPaths, hardDepthLimit);
}

}  // namespace

int runRender(const RenderOptions& options) {
  std::string const sceneFile = findScene(options.scene.scene);
  checkOutputs(options, {sceneFile});
  Scene const scene = loadScene(sceneFile);
  checkOutputs(options, filesOf(scene));
  std::string why;
  auto const integrator = makeIntegrator(scene, options.scene.settings, options.scene.backend, &why);
  if (!options.quiet && !why.empty()) printError(why);
  for (const std::string& advice : integrator->stats().advice) printError("warning: {}", advice);

  Goal goal{options.iterations, options.time};
  if (goal.iterations == 0 && goal.seconds == 0) goal.iterations = defaultIterations;
  StopOnSignal const stop;  // until the files stand
  Accumulated const run = accumulate(*integrator, goal, stop, options.quiet);

  Stats const stats = integrator->stats();
  if (run.interrupted && !options.quiet) printError("stopped early, after {} iterations", stats.iterations);
  writeOutputs(options, scene, *integrator, run);
  if (!options.quiet) printSummary(options, stats, run);
  if (!options.quiet)
    for (const std::string& note : scene.notes) printError("note: {}", note);
  if (!options.quiet) printNotes(stats);
  printWarnings(stats);
  return int(ExitCode::done);
}

}  // namespace ropelight
