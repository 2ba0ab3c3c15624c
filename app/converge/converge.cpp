#include "app/converge/converge.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <set>

#include "app/arguments/scene_path.h"
#include "app/converge/analysis/report.h"
#include "app/converge/report/json.h"
#include "app/converge/study/runner.h"
#include "app/run/interrupt.h"
#include "app/run/output.h"
#include "app/run/progress.h"
#include "app/run/standard_streams.h"
#include "app/run/version.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/image_files/exr.h"
#include "render/import/load.h"

namespace ropelight {
namespace {

using Clock = std::chrono::steady_clock;
Clock::time_point const processStart = Clock::now();

constexpr double defaultSeconds = 10;
constexpr double referenceFactor = 8;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<std::string> scenesOf(const ConvergeOptions& options) {
  std::vector<std::string> scenes = options.scenes;
  if (!options.sceneList.empty())
    for (const std::string& scene : splitText(options.sceneList, ',')) scenes.push_back(scene);
  if (scenes.empty()) throw Error("no scene; name one, or several", ExitCode::usage);
  for (std::string& scene : scenes) scene = findScene(scene);
  return scenes;
}

std::string stemOf(const std::string& file) { return std::filesystem::path(file).stem().string(); }

/// Output files are named after the scenes' files, so that those names must differ.
void requireOwnNames(const std::vector<std::string>& scenes, const ConvergeOptions& options) {
  std::set<std::string> stems;
  for (const std::string& scene : scenes)
    if (!stems.insert(stemOf(scene)).second)
      throw Error(fmt::format("{}: two scenes' files are called '{}'; study them apart", scene, stemOf(scene)),
                  ExitCode::usage);
  for (const std::string& pattern : {options.reference, options.saveReference})
    if (scenes.size() > 1 && !pattern.empty() && pattern.find("{scene}") == std::string::npos)
      throw Error(fmt::format("{}: one file for {} scenes; put {{scene}} into its name", pattern, scenes.size()),
                  ExitCode::usage);
}

struct LoadedScene {
  Scene scene;
  double seconds = 0;
};

/// Loads all scenes first, so that a broken one is found before time is spent on the others.
std::vector<LoadedScene> loadScenes(const std::vector<std::string>& files) {
  std::vector<LoadedScene> loaded;
  for (const std::string& file : files) {
    auto const start = Clock::now();
    Scene scene = loadScene(file);
    loaded.push_back({std::move(scene), since(start)});
  }
  return loaded;
}

std::string plotFile(const ConvergeOptions& options, const std::string& scene, CurveAxis axis) {
  const char* const name = axis == CurveAxis::seconds ? "seconds" : "iterations";
  return (std::filesystem::path(options.out) / fmt::format("{}-{}.svg", stemOf(scene), name)).string();
}

std::string reportFile(const ConvergeOptions& options, const char* name) {
  return (std::filesystem::path(options.out) / name).string();
}

/// Everything that can be known to fail before any time is spent.
void checkFiles(const std::vector<LoadedScene>& scenes, const ConvergeOptions& options) {
  std::vector<std::string> inputs,
      outputs{reportFile(options, "report.html"), reportFile(options, "samples.csv"), options.json};
  for (const LoadedScene& loaded : scenes) {
    const Scene& scene = loaded.scene;
    for (const std::string& file : filesOf(scene)) inputs.push_back(file);
    for (CurveAxis axis : {CurveAxis::seconds, CurveAxis::iterations})
      outputs.push_back(plotFile(options, scene.file, axis));
    if (!options.reference.empty()) inputs.push_back(forScene(options.reference, scene));
    if (!options.reference.empty()) readExrMetadata(inputs.back());
    if (!options.saveReference.empty()) outputs.push_back(forScene(options.saveReference, scene));
  }
  makeFolder(options.out);
  requireOutputs(outputs, inputs);
}

ConvergeOptions completed(ConvergeOptions options) {
  if (options.time == 0 && options.iterations == 0) options.time = defaultSeconds;
  if (!options.reference.empty() && (options.referenceTime > 0 || !options.saveReference.empty()))
    throw Error(
        "--reference: a file and the making of one exclude each other; leave out --reference-time and "
        "--save-reference",
        ExitCode::usage);
  if (options.reference.empty() && options.referenceTime == 0) {
    if (options.time == 0)
      throw Error("--iterations: how long a reference may take is not known; give --reference or --reference-time",
                  ExitCode::usage);
    options.referenceTime = referenceFactor * options.time;
  }
  return options;
}

RunnerOptions runnerOptions(const ConvergeOptions& o) {
  RunnerOptions r;
  r.modes = parseModes(o.modes, o.scene.settings);
  r.limits = {o.time, o.iterations};
  r.seeds = o.seeds;
  r.backend = o.scene.backend;
  r.trimmed = o.trimmed;
  r.reference.file = o.reference;
  r.reference.seconds = o.referenceTime;
  r.reference.mode = o.referenceMode;
  r.reference.noise = o.referenceNoise;
  r.reference.save = o.saveReference;
  r.reference.epsilon = o.epsilon;
  if (!o.referenceMode.empty()) parseModes(o.referenceMode, o.scene.settings);
  return r;
}

Study emptyStudy(const ConvergeOptions& options) {
  Study study;
  study.command = options.commandLine;
  study.version = version;
  study.threads = options.scene.backend.threads;
  study.seconds = options.time;
  study.iterations = options.iterations;
  study.seeds = options.seeds;
  study.trimmed = options.trimmed;
  study.startSeconds = since(processStart);
  return study;
}

std::string timeText(const TimeTo& time, std::size_t runs) {
  if (time.reached == 0) return "not reached";
  if (std::size_t(time.reached) < runs) return fmt::format("{} of {} runs", time.reached, runs);
  return fmt::format("{:.3g} s", time.median);
}

void print(std::FILE* out, const Study& study, const StudyScene& scene) {
  printTo(out, "\n{}: against {}\n", scene.name, scene.reference.origin);
  printTo(out, "  {:<28}{:>12}{:>12}{:>14}{:>14}{:>14}{:>9}\n", "mode", "error", "iterations", "to 0.1", "to 0.01",
          "to 0.001", "slope");
  for (const StudyMode& mode : scene.modes) {
    if (mode.runs.empty() || mode.runs[0].samples.empty()) continue;
    auto const band = bandOf(mode, CurveAxis::seconds, study.trimmed);
    printTo(out, "  {:<28}{:>12.4g}{:>12}", mode.label,
            band.empty() ? errorOf(mode.runs[0].samples.back().metrics, study.trimmed) : band.back().median,
            mode.runs[0].samples.back().iterations);
    for (double const error : reportedErrors)
      printTo(out, "{:>14}", timeText(timeTo(mode, error, study.trimmed), std::size_t(seedsOf(mode))));
    printTo(out, "{:>9.2f}\n", slopeOf(mode, CurveAxis::seconds, study.trimmed).median);
    if (!mode.referenceWarning.empty()) printTo(out, "    note: {}\n", mode.referenceWarning);
  }
  printTo(out, "  {}\n", verdictOf(scene, study.trimmed));
}

/// After every scene, so that a long study leaves what it has.
void writeReport(const ConvergeOptions& options, const Study& study) {
  std::vector<std::function<void()>> writers;
  for (const StudyScene& scene : study.scenes)
    for (CurveAxis const axis : {CurveAxis::seconds, CurveAxis::iterations})
      writers.push_back(
          [&, axis] { writeFile(plotFile(options, scene.file, axis), toSvg(errorPlot(study, scene, axis))); });
  writers.push_back([&] { writeFile(reportFile(options, "samples.csv"), toCsv(study)); });
  writers.push_back([&] { writeFile(reportFile(options, "report.html"), toHtml(study)); });
  if (!options.json.empty() && options.json != "-") writers.push_back([&] { writeJson(options.json, toJson(study)); });
  writeAll(writers);
}

}  // namespace

int runConverge(const ConvergeOptions& given) {
  ConvergeOptions const options = completed(given);
  RunnerOptions runner = runnerOptions(options);
  std::vector<std::string> const files = scenesOf(options);
  requireOwnNames(files, options);
  std::vector<LoadedScene> const scenes = loadScenes(files);
  checkFiles(scenes, options);
  std::FILE* const out = options.json == "-" ? stderr : stdout;
  Study study = emptyStudy(options);
  StopOnSignal const stop;
  runner.stop = [&] { return stop.requested(); };
  for (const LoadedScene& loaded : scenes) {
    const Scene& scene = loaded.scene;
    if (!options.quiet) printError(scene.name);
    double const runs = double(runner.modes.size()) * options.seeds;
    Progress progress({std::uint64_t(double(options.iterations) * runs), options.time * runs}, options.quiet);
    runner.progress = [&](std::uint64_t iterations, double seconds) { progress.update(iterations, seconds); };
    study.scenes.push_back(runModes(scene, options.scene.settings, runner));
    study.scenes.back().loadSeconds += loaded.seconds;
    study.device = study.scenes.back().device;
    study.complete = !stop.requested();
    print(out, study, study.scenes.back());
    writeReport(options, study);
    if (stop.requested()) break;
  }
  if (!study.complete && !options.quiet) printError("stopped early");
  if (options.json == "-") writeJson("-", toJson(study));
  if (!options.quiet) printTo(out, "\nwrote {}\n", reportFile(options, "report.html"));
  return int(ExitCode::done);
}

}  // namespace ropelight
