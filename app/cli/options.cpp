#include "app/cli/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/arguments/scene_arguments.h"
#include "app/run/version.h"
#include "render/core/error.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

constexpr const char* jsonDoc = "write statistics as JSON; '-': standard output";

std::unique_ptr<CLI::App> makeApp(const char* name, const char* doc) {
  auto app = std::make_unique<CLI::App>(doc, fmt::format("ropelight {}", name));
  app->set_help_flag("-h,--help", "print this help");
  return app;
}

void addSceneName(CLI::App& app, std::string& scene) {
  app.add_option("SCENE", scene, "scene file (.json, .obj) or the name of an asset")->required()->type_name("");
}

CLI::Option* addFile(CLI::App& app, const char* flags, std::string& file, const char* doc) {
  return app.add_option(flags, file, doc)->type_name("FILE")->take_last();
}

/// Parses one subcommand's arguments (the program's and its own name left off) into options that `declare` binds.
template <class Options, class Declare>
Command parse(const char* name, const char* doc, std::vector<std::string> arguments, Declare declare) {
  Options options;
  auto const app = makeApp(name, doc);
  declare(*app, options);
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 takes
  try {
    app->parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    return Message{app->help()};
  } catch (const CLI::ParseError& error) {
    throw Error(fmt::format("{}; see ropelight {} --help", error.what(), name), ExitCode::usage);
  }
  return options;
}

using Arguments = std::vector<std::string>;

Command parseView(const char* name, const char* doc, Arguments arguments) {
  return parse<ViewOptions>(name, doc, std::move(arguments), [](CLI::App& app, ViewOptions& o) {
    addSceneName(app, o.scene.scene);
    addFile(app, "--reference", o.reference, ".exr or .png to measure errors against");
    app.add_flag("--watch", o.watch, "load the scene again when its files change");
    addValue(app, "--frames", o.frames, ParamInfo{"end after N frames of one iteration each", 1, 1e12});
    addFile(app, "--screenshot", o.screenshot, "PNG of the whole window at the end");
    addFile(app, "--state", o.state, "JSON of what the window shows at the end");
    addFile(app, "--script", o.script, "input to play, one command a line");
    app.add_flag("--no-interop", o.noInterop, "copy pixels through host memory");
    addValue(app, "--ui-scale", o.uiScale, ParamInfo{"of text and spacing, beyond the monitor's own", 0.5, 4});
    app.add_option("--window", o.window, "WIDTHxHEIGHT of the window")->type_name("")->take_last();
    app.add_flag("--no-preferences", o.noPreferences, "neither read nor write what is kept between runs");
    addSceneArguments(app, o.scene);
  });
}

Command parseRender(const char* name, const char* doc, Arguments arguments) {
  return parse<RenderOptions>(name, doc, std::move(arguments), [](CLI::App& app, RenderOptions& o) {
    addSceneName(app, o.scene.scene);
    app.add_option("-o,--output", o.outputs, "image, .png or .exr; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->default_str("out.png");
    addValue(app, "--iterations", o.iterations, ParamInfo{"stop after so many; 64 without a limit", 1, 1e15})
        ->default_str("");
    addValue(app, "--time", o.time, ParamInfo{"stop after so long", 1e-3, 1e9, "seconds"})->default_str("");
    addFile(app, "--json", o.json, jsonDoc);
    app.add_flag("--quiet", o.quiet, "no progress and no summary");
    addSceneArguments(app, o.scene);
  });
}

Command parseInfo(const char* name, const char* doc, Arguments arguments) {
  return parse<InfoOptions>(name, doc, std::move(arguments), [](CLI::App& app, InfoOptions& o) {
    addSceneName(app, o.scene.scene);
    addFile(app, "--json", o.json, jsonDoc);
    addSceneArguments(app, o.scene);
  });
}

Command parseDevices(const char* name, const char* doc, Arguments arguments) {
  return parse<DevicesOptions>(name, doc, std::move(arguments),
                               [](CLI::App& app, DevicesOptions& o) { addFile(app, "--json", o.json, jsonDoc); });
}

Command parseCompare(const char* name, const char* doc, Arguments arguments) {
  return parse<CompareOptions>(name, doc, std::move(arguments), [](CLI::App& app, CompareOptions& o) {
    app.add_option("IMAGE", o.image, ".exr or .png")->required()->type_name("");
    app.add_option("REFERENCE", o.reference, ".exr or .png of the same size")->required()->type_name("");
    app.add_option("--metric", o.metric, fmt::format("what the threshold is for: {}", joinNames(compareMetricNames())))
        ->type_name("")
        ->default_str(o.metric);
    addValue(app, "--threshold", o.threshold, ParamInfo{"fail (exit 6) above it; for psnr, below it"});
    addValue(app, "--epsilon", o.epsilon, ParamInfo{"of relMSE; by default 0.01 mean(reference^2)", 0});
    addFile(app, "--error-image", o.errorImage, "write the signed relative error, .exr or .png");
    addFile(app, "--flip-image", o.flipImage, "write where the images look different (FLIP), .exr or .png");
    addFile(app, "--json", o.json, jsonDoc);
  });
}

Command parseBench(const char* name, const char* doc, Arguments arguments) {
  return parse<BenchOptions>(name, doc, std::move(arguments), [](CLI::App& app, BenchOptions& o) {
    app.add_option("NAME", o.names, fmt::format("by default all that need no window, of: {}", joinNames(benchNames())))
        ->type_name("");
    app.add_option("--scene", o.scene.scene, "scene file or asset instead of the benchmark's own")->type_name("SCENE");
    addValue(app, "--repeat", o.repeat, ParamInfo{"timed repetitions", 1, 1e6});
    addFile(app, "--json", o.json, jsonDoc);
    addFile(app, "--csv", o.csv, "write the rows as CSV");
    app.add_option("--out", o.out, "folder for NAME.csv and NAME.svg of every benchmark")
        ->type_name("FOLDER")
        ->take_last();
    app.add_flag("--full", o.full, "a GPU's numbers of rays, photons and triangles on the CPU too");
    addFile(app, "--mesh", o.mesh, "OBJ file for traversal instead of a generated mesh");
    addSceneArguments(app, o.scene);
  });
}

Command parseStress(const char* name, const char* doc, Arguments arguments) {
  return parse<StressOptions>(name, doc, std::move(arguments), [](CLI::App& app, StressOptions& o) {
    addValue(app, "--rays", o.rays, ParamInfo{"rays for every mesh and traversal", 1, 1e12});
    addValue(app, "--seed", o.seed, ParamInfo{"random seed", 0, 4294967295.0});
    app.add_flag("--full", o.full, "a mesh of a million triangles too");
    addFile(app, "--mesh", o.mesh, "OBJ file to be checked too");
    addFile(app, "--json", o.json, jsonDoc);
    addBackendArguments(app, o.backend);
  });
}

/// Quoted where a shell would need it.
std::string quoted(const std::string& argument) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
  std::string text = "'";
  for (char const c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string asTyped(const Arguments& arguments) {
  std::string line = "ropelight converge";
  for (const std::string& argument : arguments) line += " " + quoted(argument);
  return line;
}

Command parseConverge(const char* name, const char* doc, Arguments arguments) {
  std::string const commandLine = asTyped(arguments);
  Command command = parse<ConvergeOptions>(name, doc, std::move(arguments), [](CLI::App& app, ConvergeOptions& o) {
    app.add_option("SCENE", o.scenes, "scene files or names of assets")->type_name("");
    addFile(app, "--scenes", o.sceneList, "more scenes, apart by commas")->type_name("LIST");
    addFile(app, "--modes", o.modes, "what to compare, apart by commas, settings after colons: path,sppm:alpha=0.5")
        ->type_name("LIST")
        ->default_str(o.modes);
    addValue(app, "--time", o.time, ParamInfo{"limit of every run; 10 without a limit", 1e-3, 1e9, "seconds"})
        ->default_str("");
    addValue(app, "--iterations", o.iterations, ParamInfo{"limit of every run", 1, 1e15})->default_str("");
    addValue(app, "--seeds", o.seeds, ParamInfo{"runs of every mode", 1, 1000});
    addFile(app, "--reference", o.reference, ".exr to measure against; {scene} stands for the scene's file name");
    addValue(app, "--reference-time", o.referenceTime,
             ParamInfo{"to make a reference in; 8 times --time unless given", 1e-3, 1e9, "seconds"})
        ->default_str("");
    addFile(app, "--reference-mode", o.referenceMode,
            "what makes it; unless given path or sppm, whichever trials say will be nearer")
        ->type_name("MODE");
    addValue(app, "--reference-noise", o.referenceNoise, ParamInfo{"relMSE of the noise of --reference", 0});
    addFile(app, "--save-reference", o.saveReference, ".exr to keep a made reference in; {scene} as above");
    addValue(app, "--epsilon", o.epsilon, ParamInfo{"of relMSE; by default 0.01 mean(reference^2)", 0});
    app.add_flag("--trimmed", o.trimmed, "leave the worst 0.1% of pixels out of the headline figure");
    app.add_option("--out", o.out, "folder for the report")->type_name("FOLDER")->take_last()->default_str(o.out);
    addFile(app, "--json", o.json, "write samples, errors' split and settings as JSON; '-': standard output");
    app.add_flag("--quiet", o.quiet, "no progress");
    addSceneArguments(app, o.scene);
  });
  if (auto* options = std::get_if<ConvergeOptions>(&command)) options->commandLine = commandLine;
  return command;
}

struct Subcommand {
  const char* name;
  const char* arguments;
  const char* doc;
  Command (*parse)(const char* name, const char* doc, Arguments);
};

constexpr Subcommand subcommands[] = {
    {"view", "SCENE", "Show a scene in a window; taken where no subcommand is named.", parseView},
    {"render", "SCENE -o FILE", "Render a scene to image files.", parseRender},
    {"info", "SCENE", "Say what a scene needs, what is left out, and its memory.", parseInfo},
    {"devices", "", "List the CPU and the GPUs.", parseDevices},
    {"compare", "IMAGE REFERENCE", "Measure how far an image is from a reference.", parseCompare},
    {"bench", "[NAME...]", "Measure speed.", parseBench},
    {"converge", "SCENE...", "Measure error against run time, mode by mode.", parseConverge},
    {"stress", "", "Check every traversal on the rays and meshes on which tracers fail.", parseStress},
};

/// A line that names no subcommand is for the viewer, unless its first word is a mistyped one.
Command parseDefault(Arguments arguments) {
  std::string const first = arguments[0];
  try {
    return parseView("view", subcommands[0].doc, std::move(arguments));
  } catch (const Error& error) {
    if (first[0] == '-') throw;
    throw Error(fmt::format("{} ('{}' is no subcommand and was taken for a scene)", error.what(), first), error.code());
  }
}

std::string overview() {
  std::string text = "ropelight: stochastic progressive photon mapping on the CPU and on CUDA\n\n";
  for (const Subcommand& s : subcommands)
    text += fmt::format("  {:<38}{}\n", fmt::format("ropelight {} {}", s.name, s.arguments), s.doc);
  text += fmt::format("  {:<38}{}\n", "ropelight --version", "Print the version.");
  return text + "\nropelight SUBCOMMAND --help lists a subcommand's options.\n";
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv) {
  Arguments arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) throw Error("no scene and no subcommand; see ropelight --help", ExitCode::usage);
  if (arguments[0] == "--help" || arguments[0] == "-h") return Message{overview()};
  if (arguments[0] == "--version") return Message{fmt::format("ropelight {}\n", version)};
  for (const Subcommand& s : subcommands)
    if (arguments[0] == s.name) return s.parse(s.name, s.doc, {arguments.begin() + 1, arguments.end()});
  return parseDefault(std::move(arguments));
}

}  // namespace ropelight
