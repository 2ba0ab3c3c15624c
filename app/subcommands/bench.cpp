#include "app/bench/bench.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, BenchOptions& o) {
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
}

Command parseBench(const Subcommand& self, Arguments arguments) {
  return parse<BenchOptions>(self, std::move(arguments), declare, [](const BenchOptions& o) { return runBench(o); });
}

}  // namespace

constinit const Subcommand benchCommand{"bench", "[NAME...]", "Measure speed.", parseBench};

}  // namespace ropelight
