#include "app/commands/info.h"

#include <fmt/format.h>

#include <array>

#include "app/arguments/scene_path.h"
#include "app/run/output.h"
#include "app/run/report.h"
#include "app/run/standard_streams.h"
#include "app/run/version.h"
#include "render/core/error.h"
#include "render/core/features.h"
#include "render/import/load.h"

namespace ropelight {
namespace {

using Json = nlohmann::ordered_json;

Json countShapes(const Scene& scene) {
  std::array<std::uint64_t, 4> kinds{};
  std::uint64_t triangles = 0;
  std::uint64_t emitters = 0;
  for (const ShapeDesc& shape : scene.shapes) {
    ++kinds[std::size_t(shape.kind)];
    if (shape.kind == ShapeKind::mesh) triangles += scene.meshes[std::size_t(shape.mesh)].triangles.size();
    if (shape.emission) ++emitters;
  }
  auto const count = [&](ShapeKind kind) { return kinds[std::size_t(kind)]; };
  return {{"spheres", count(ShapeKind::sphere)}, {"boxes", count(ShapeKind::box)}, {"quads", count(ShapeKind::quad)},
          {"meshes", count(ShapeKind::mesh)},    {"triangles", triangles},         {"emitters", emitters}};
}

Json countMaterials(const Scene& scene) {
  Json counts = Json::object();
  for (const NamedMaterial& material : scene.materials) {
    const char* const kind = std::visit([](const auto& params) { return params.name; }, material.desc);
    counts[kind] = counts.value(kind, 0) + 1;
  }
  return counts;
}

Json describeFeatures(FeatureBits features) {
  Json present = Json::array();
  Json leftOut = Json::array();
  for (const FeatureName& f : featureNames) (features & f.bit ? present : leftOut).push_back(f.name);
  return {{"present", present}, {"leftOut", leftOut}};
}

void printCounts(const char* title, const Json& counts) {
  fmt::print("{:<12}", title);
  const char* separator = "";
  for (const auto& [name, count] : counts.items()) {
    fmt::print("{}{} {}", separator, count.get<std::uint64_t>(), name);
    separator = ", ";
  }
  fmt::print("\n");
}

void printFeatures(FeatureBits features) {
  for (bool const present : {true, false}) {
    fmt::print("\n{}\n", present ? "present" : "left out");
    for (const FeatureName& f : featureNames)
      if (bool(features & f.bit) == present) fmt::print("  {:<12}{}\n", f.name, f.what);
  }
}

void printMemory(const Stats& stats) {
  fmt::print("\nmemory\n");
  std::uint64_t total = 0;
  for (const auto& [purpose, bytes] : stats.bytes) {
    fmt::print("  {:<20}{:>12}\n", purpose, formatBytes(bytes));
    total += bytes;
  }
  fmt::print("  {:<20}{:>12}\n", "total", formatBytes(total));
}

void printText(const Scene& scene, const Settings& settings, const Stats& stats) {
  fmt::print("{:<12}{}\n", "scene", scene.file);
  printCounts("shapes", countShapes(scene));
  printCounts("materials", countMaterials(scene));
  fmt::print("{:<12}{} x {} pixels\n", "image", settings.width, settings.height);
  fmt::print("{:<12}{}\n", "device", stats.device);
  fmt::print("{:<12}{}, kernels: {}\n", "rays", stats.accel, stats.kernelRow);
  if (stats.treeNodes > 0)
    fmt::print("{:<12}{} nodes, {} leaves, depth {}, SAH cost {:.1f}, built in {:.3f} s\n", "tree", stats.treeNodes,
               stats.treeLeaves, stats.treeDepth, stats.treeCost, stats.treeSeconds);
  if (stats.firstRadius > 0) fmt::print("{:<12}{:.6g} scene units at first\n", "radius", stats.firstRadius);
  if (stats.firstCausticRadius > 0)
    fmt::print("{:<12}{:.6g} scene units at first\n", "caustics", stats.firstCausticRadius);
  for (const std::string& note : scene.notes) fmt::print("{:<12}{}\n", "note", note);
  printFeatures(stats.features);
  printMemory(stats);
}

/// The budget that scripts/kernels.py holds the build to.
constexpr int mostRegisters = 128;

/// Exit code: checkFailed where a kernel takes more registers than the budget has.
int printKernels(const BackendChoice& backend) {
  std::vector<KernelUse> const uses = kernelUses(backend);
  if (uses.empty()) {
    fmt::print("kernels     on the CPU nothing is counted; choose a GPU, or run scripts/kernels.py\n");
    return int(ExitCode::done);
  }
  bool above = false;
  fmt::print("{:<14}{:<14}{:>10}{:>14}{:>6}\n", "stage", "row", "registers", "local, bytes", "sm");
  for (const KernelUse& k : uses) {
    above = above || k.registers > mostRegisters;
    fmt::print("{:<14}{:<14}{:>10}{:>14}{:>6}{}\n", k.stage, k.row, k.registers, k.localBytes, k.architecture,
               k.registers > mostRegisters ? fmt::format("  more than {}", mostRegisters) : "");
  }
  return int(above ? ExitCode::checkFailed : ExitCode::done);
}

}  // namespace

int runInfo(const InfoOptions& options) {
  if (options.kernels) return printKernels(options.scene.backend);
  if (options.scene.scene.empty()) throw Error("info: SCENE is required, or --kernels", ExitCode::usage);
  std::string const sceneFile = findScene(options.scene.scene);
  requireOutputs({options.json}, {sceneFile});
  Scene const scene = loadScene(sceneFile);
  requireOutputs({options.json}, filesOf(scene));
  std::string why;
  auto const integrator = makeIntegrator(scene, options.scene.settings, options.scene.backend, &why);
  if (!why.empty()) printError(why);
  Stats const stats = integrator->stats();
  for (const std::string& advice : stats.advice) printError("warning: {}", advice);
  const Settings& settings = stats.settings;
  if (options.json != "-") printText(scene, settings, stats);
  if (!options.json.empty())
    writeJson(options.json, {{"version", version},
                             {"scene", scene.file},
                             {"shapes", countShapes(scene)},
                             {"materials", countMaterials(scene)},
                             {"notes", scene.notes},
                             {"features", describeFeatures(stats.features)},
                             {"settings", toJson(settings)},
                             {"stats", toJson(stats)}});
  return int(ExitCode::done);
}

}  // namespace ropelight
