#include "app/converge/converge.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

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

void addInput(CLI::App& app, ConvergeOptions& o) {
  app.add_option("SCENE", o.scenes, "scene files or names of assets")->type_name("");
  addFile(app, "--scenes", o.sceneList, "more scenes, apart by commas")->type_name("LIST");
  addFile(app, "--modes", o.modes, "what to compare, apart by commas, settings after colons: path,sppm:alpha=0.5")
      ->type_name("LIST")
      ->default_str(o.modes);
  addValue(app, "--time", o.time, ParamInfo{"limit of every run; 10 without a limit", 1e-3, 1e9, "seconds"})
      ->default_str("");
  addValue(app, "--iterations", o.iterations, ParamInfo{"limit of every run", 1, 1e15})->default_str("");
  addValue(app, "--seeds", o.seeds, ParamInfo{"runs of every mode", 1, 1000});
}

void addReference(CLI::App& app, ConvergeOptions& o) {
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
}

void addOutput(CLI::App& app, ConvergeOptions& o) {
  app.add_flag("--trimmed", o.trimmed, "leave the worst 0.1% of pixels out of the headline figure");
  app.add_option("--out", o.out, "folder for the report")->type_name("FOLDER")->take_last()->default_str(o.out);
  addFile(app, "--json", o.json, "write samples, errors' split and settings as JSON; '-': standard output");
  app.add_flag("--quiet", o.quiet, "no progress");
}

Command parseConverge(const Subcommand& self, Arguments arguments) {
  std::string const commandLine = asTyped(arguments);
  auto const declare = [&](CLI::App& app, ConvergeOptions& o) {
    o.commandLine = commandLine;
    addInput(app, o);
    addReference(app, o);
    addOutput(app, o);
    addSceneArguments(app, o.scene);
  };
  return parse<ConvergeOptions>(self, std::move(arguments), declare, runConverge);
}

}  // namespace

constinit const Subcommand convergeCommand{"converge", "SCENE...", "Measure error against run time, mode by mode.",
                                           parseConverge};

}  // namespace ropelight
