#include "app/commands/compare.h"
#include "app/arguments/scene_arguments.h"
#include "app/subcommands/parse.h"
#include "app/subcommands/subcommands.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

void declare(CLI::App& app, CompareOptions& o) {
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
}

Command parseCompare(const Subcommand& self, Arguments arguments) {
  return parse<CompareOptions>(self, std::move(arguments), declare, runCompare);
}

}  // namespace

constinit const Subcommand compareCommand{"compare", "IMAGE REFERENCE", "Measure how far an image is from a reference.",
                                          parseCompare};

}  // namespace ropelight
