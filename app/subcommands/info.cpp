#include "app/commands/info.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, InfoOptions& o) {
  addSceneName(app, o.scene.scene);
  app.get_option("SCENE")->required(false);  // --kernels needs none
  app.add_flag("--kernels", o.kernels, "registers and local memory of every kernel instead; needs no scene");
  addFile(app, "--json", o.json, jsonDoc);
  addSceneArguments(app, o.scene);
}

Command parseInfo(const Subcommand& self, Arguments arguments) {
  return parse<InfoOptions>(self, std::move(arguments), declare, runInfo);
}

}  // namespace

constinit const Subcommand infoCommand{"info", "SCENE", "Say what a scene needs, what is left out, and its memory.",
                                       parseInfo};

}  // namespace ropelight
