#include "app/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/accumulate.h"
#include "app/output.h"
#include "app/report.h"
#include "app/scene_path.h"
#include "render/core/error.h"
#include "render/core/version.h"
#include "render/film/exr.h"
#include "render/film/png.h"
#include "render/scene/load.h"

namespace ropelight {
namespace {

constexpr std::uint64_t defaultIterations = 64;

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// Everything that can be known to fail before any time is spent.
void checkOutputs(const RenderOptions& options) {
  for (const std::string& path : options.outputs) {
    std::string const extension = extensionOf(path);
    if (extension != ".png" && extension != ".exr")
      throw Error(fmt::format("{}: an image file ends in .png or .exr; name it so", path), ExitCode::usage);
  }
  for (const std::string& path : options.outputs) requireWritable(path);
  if (!options.json.empty() && options.json != "-") requireWritable(options.json);
}

void writeImage(const std::string& path, const Image& image, const Metadata& metadata) {
  if (extensionOf(path) == ".exr")
    writeExr(path, image, metadata);
  else
    writePng(path, image);
}

/// Tries every file, so that one full disk does not cost the others; then throws what went wrong first.
void writeImages(const std::vector<std::string>& paths, const Image& image, const Metadata& metadata) {
  std::optional<Error> failed;
  for (const std::string& path : paths) {
    try {
      writeImage(path, image, metadata);
    } catch (const Error& error) {
      if (!failed) failed = error;
    }
  }
  if (failed) throw *failed;
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

void printSummary(const RenderOptions& options, const Stats& stats, const Accumulated& run) {
  std::FILE* const stream = options.json == "-" ? stderr : stdout;
  fmt::print(stream, "{} iterations in {:.2f} s: {:.3g} it/s, {:.3g} Mrays/s, {:.3g} Mphotons/s on {}; wrote {}\n",
             stats.iterations, run.seconds, iterationRate(stats), megaRays(stats), megaPhotons(stats), stats.device,
             fmt::join(options.outputs, ", "));
}

void printWarnings(const Stats& stats) {
  if (stats.regrown > 0)
    fmt::print(stderr, "note: photons were traced again {} times after their storage had grown\n", stats.regrown);
  if (stats.chunks > 1) fmt::print(stderr, "note: each iteration's photons were traced in {} parts\n", stats.chunks);
  if (stats.nonFinite > 0)
    fmt::print(stderr, "warning: {} samples were NaN or infinite and were left out of the image\n", stats.nonFinite);
  if (stats.truncatedPaths > 0)
    fmt::print(stderr, "warning: {} paths were cut at {} edges; their light is missing\n", stats.truncatedPaths,
               hardDepthLimit);
}

}  // namespace

int runRender(const RenderOptions& options) {
  checkOutputs(options);
  Scene const scene = loadScene(findScene(options.scene.scene));
  std::string why;
  auto const integrator = makeIntegrator(scene, options.scene.settings, options.scene.backend, &why);
  if (!options.quiet && !why.empty()) fmt::print(stderr, "{}\n", why);

  Goal goal{options.iterations, options.time};
  if (goal.iterations == 0 && goal.seconds == 0) goal.iterations = defaultIterations;
  Accumulated const run = accumulate(*integrator, goal, options.quiet);

  Stats const stats = integrator->stats();
  const Settings& settings = stats.settings;
  writeImages(options.outputs, integrator->film(), imageMetadata(settings, scene, stats));
  if (!options.json.empty()) writeJson(options.json, statistics(options, scene, settings, stats, run));
  if (run.interrupted) fmt::print(stderr, "stopped early, after {} iterations\n", stats.iterations);
  if (!options.quiet) printSummary(options, stats, run);
  if (!options.quiet)
    for (const std::string& note : scene.notes) fmt::print(stderr, "note: {}\n", note);
  printWarnings(stats);
  return int(ExitCode::done);
}

}  // namespace ropelight
