#include "app/commands/render.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, RenderOptions& o) {
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
}

Command parseRender(const Subcommand& self, Arguments arguments) {
  return parse<RenderOptions>(self, std::move(arguments), declare, runRender);
}

}  // namespace

constinit const Subcommand renderCommand{"render", "SCENE -o FILE", "Render a scene to image files.", parseRender};

}  // namespace ropelight
