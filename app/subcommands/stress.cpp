#include "app/stress/stress.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, StressOptions& o) {
  app.add_option("NAME", o.names, "cases or families, by default all; --list names them")->type_name("");
  app.add_flag("--list", o.list, "print the catalogue instead: what is hard, what is measured, against what");
  app.add_flag("--short", o.isShort, "the part that the tests run, with fewer samples");
  addValue(app, "--seed", o.seed, ParamInfo{"random seed", 0, 4294967295.0});
  addFile(app, "--json", o.json, jsonDoc);
  app.add_option("--out", o.out, "folder for stability.html and an SVG of every sweep")
      ->type_name("FOLDER")
      ->take_last();
  addValue(app, "--rays", o.rays.rays, ParamInfo{"of family 'rays': rays for every mesh and traversal", 1, 1e12});
  app.add_flag("--full", o.rays.full, "of family 'rays': a mesh of a million triangles too");
  addFile(app, "--mesh", o.rays.mesh, "of family 'rays': OBJ file to be checked too");
  addBackendArguments(app, o.backend);
}

Command parseStress(const Subcommand& self, Arguments arguments) {
  return parse<StressOptions>(self, std::move(arguments), declare, runStress);
}

}  // namespace

constinit const Subcommand stressCommand{
    "stress", "[NAME...]", "Measure stiff and extreme cases against answers that are known.", parseStress};

}  // namespace ropelight
