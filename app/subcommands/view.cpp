#include "app/viewer/view.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, ViewOptions& o) {
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
}

Command parseView(const Subcommand& self, Arguments arguments) {
  return parse<ViewOptions>(self, std::move(arguments), declare, runView);
}

}  // namespace

constinit const Subcommand viewCommand{"view", "SCENE", "Show a scene in a window; taken where no subcommand is named.",
                                       parseView};

}  // namespace ropelight
