#include "render/integrator/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"
#include "render/integrator/first_radius.h"

namespace ropelight {
namespace {

void requireOneOf(const char* name, const std::string& value, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  throw Error(fmt::format("--{}: '{}' is not known; use one of: {}", name, value, fmt::join(known, ", ")),
              ExitCode::usage);
}

void resolve(const Scene& scene, std::uint32_t primitives, Settings& s) {
  if (s.width == 0) s.width = scene.film.width;
  if (s.height == 0) s.height = scene.film.height;
  if (std::uint64_t(s.width) * std::uint64_t(s.height) > (1u << 28))
    throw Error(fmt::format("film: {} x {} pixels; at most 2^28 fit", s.width, s.height), ExitCode::usage);
  if (s.maxDepth == 0) s.maxDepth = hardDepthLimit;
  if (s.treeDepth == 0) s.treeDepth = automaticTreeDepth(primitives);
}

}  // namespace

FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& s) {
  FeatureBits bits = featuresOf(flat, camera);
  bool const tree = s.accel == "tree" || (s.accel == "auto" && flat.primitiveCount() > bruteForceLimit);
  if (tree && flat.primitiveCount() > 0) bits |= feature::tree;
  if (s.mode == "sppm" && (bits & feature::lights) && (bits & feature::diffuse)) bits |= feature::photons;
  if ((bits & feature::photons) && s.gather == "nearest") bits |= feature::nearest;
  return bits;
}

Prepared prepare(const Scene& scene, const Settings& settings, const BackendChoice& backend) {
  requireOneOf("mode", settings.mode, modeNames());
  requireOneOf("direct", settings.direct, {"shadow", "photons"});
  requireOneOf("gather", settings.gather, {"radius", "nearest"});
  requireOneOf("accel", settings.accel, {"auto", "tree", "brute"});
  requireOneOf("split", settings.split, {"sah", "midpoint"});
  requireOneOf("sampler", settings.sampler, {"sobol", "independent"});
  Prepared p;
  p.flat = flatten(scene);
  p.camera = scene.camera;
  p.settings = settings;
  p.backend = backend;
  resolve(scene, p.flat.primitiveCount(), p.settings);
  p.features = featuresOf(p.flat, p.camera, p.settings);
  if (p.features & feature::tree) {
    KdConfig config;
    config.midpoint = settings.split == "midpoint";
    config.bins = settings.bins;
    config.leafSize = settings.leafSize;
    config.maxDepth = p.settings.treeDepth;
    p.tree = buildKdTree(p.flat, config);
  }
  p.settings.accel = (p.features & feature::tree) ? "tree" : "brute";
  if ((p.features & feature::photons) && p.settings.radius == 0) p.settings.radius = automaticRadius(p);
  return p;
}

double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor) {
  double const i = double(iteration);
  double const logRatio = std::lgamma(i + alpha) - std::lgamma(1 + alpha) - std::lgamma(i + 1);
  return std::max(firstRadius * std::exp(0.5 * logRatio), floor);
}

}  // namespace ropelight
