#include "app/stress/stress.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, StressOptions& o) {
  addValue(app, "--rays", o.rays, ParamInfo{"rays for every mesh and traversal", 1, 1e12});
  addValue(app, "--seed", o.seed, ParamInfo{"random seed", 0, 4294967295.0});
  app.add_flag("--full", o.full, "a mesh of a million triangles too");
  addFile(app, "--mesh", o.mesh, "OBJ file to be checked too");
  addFile(app, "--json", o.json, jsonDoc);
  addBackendArguments(app, o.backend);
}

Command parseStress(const Subcommand& self, Arguments arguments) {
  return parse<StressOptions>(self, std::move(arguments), declare, runStress);
}

}  // namespace

constinit const Subcommand stressCommand{
    "stress", "", "Check every traversal on the rays and meshes on which tracers fail.", parseStress};

}  // namespace ropelight
