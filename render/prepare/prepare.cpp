#include "render/prepare/prepare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"
#include "render/launch/rows.h"
#include "render/prepare/first_radius.h"
#include "render/prepare/memory_need.h"
#include "render/prepare/structure_choice.h"

namespace ropelight {
namespace {

/// Every text setting is one of the choices that its list names.
void checkChoices(Settings s) {
  s.params([](const char* name, const auto& value, const ParamInfo& info) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
      std::vector<std::string> const known = choicesOf(info);
      if (std::find(known.begin(), known.end(), value) == known.end())
        throw Error(fmt::format("--{}: '{}' is not known; use one of: {}", name, value, fmt::join(known, ", ")),
                    ExitCode::usage);
    }
  });
  bool const ofGather = s.aov == "photon-count" || s.aov == "gather-radius";
  if (ofGather && s.mode != "sppm")
    throw Error(fmt::format("--aov {}: only --mode sppm gathers photons", s.aov), ExitCode::usage);
}

void resolve(const FilmDesc& film, std::uint32_t primitives, Settings& s) {
  if (s.width == 0) s.width = film.width;
  if (s.height == 0) s.height = film.height;
  if (std::uint64_t(s.width) * std::uint64_t(s.height) > (1u << 28))
    throw Error(fmt::format("film: {} x {} pixels; at most 2^28 fit", s.width, s.height), ExitCode::usage);
  if (s.maxDepth == 0) s.maxDepth = hardDepthLimit;
  if (s.treeDepth == 0) s.treeDepth = automaticTreeDepth(primitives);
}

/// The setting that asks for what the features say.
const char* accelName(FeatureBits features) {
  if (features & feature::shortStack) return "short-stack";
  if (features & feature::tree) return "tree";
  return (features & feature::bvh) ? "bvh" : "brute";
}

/// All but the structure and the first radius.
void resolveAll(Prepared& p, const Settings& requested) {
  checkChoices(requested);
  p.requested = p.settings = requested;
  resolve(p.film, p.flat->primitiveCount(), p.settings);
  p.features = featuresOf(*p.flat, p.camera, p.settings);
  p.settings.accel = accelName(p.features);
}

void resolveRadius(Prepared& p) {
  if ((p.features & feature::photons) && p.settings.radius == 0) p.settings.radius = automaticRadius(p);
}

KdConfig treeConfig(const Settings& s, int threads = 0) {
  KdConfig config;
  config.threads = threads;
  config.split = s.split == "sweep" ? KdSplit::sweep : (s.split == "midpoint" ? KdSplit::midpoint : KdSplit::sah);
  config.bins = s.bins;
  config.leafSize = s.leafSize;
  config.maxDepth = s.treeDepth;
  return config;
}

/// things: what testing all of them would test.
FeatureBits structureFor(std::uint32_t things, const Settings& s) {
  if (things == 0 || s.accel == "brute") return 0;
  if (s.accel == "tree") return feature::tree;
  if (s.accel == "short-stack") return feature::tree | feature::shortStack;
  return s.accel == "bvh" || things > bruteForceLimit ? feature::bvh : 0;
}

void buildStructures(Prepared& p, SceneCache& cache) {
  if (p.features & feature::tree) {
    p.tree = cache.tree(p.flat, treeConfig(p.settings, p.backend.threads));
    p.meshTrees = cache.meshTrees(
        *p.flat, treeConfig(p.requested, p.backend.threads));  // each mesh has an automatic depth of its own
  }
  if (p.features & feature::bvh) {
    BvhConfig config;
    config.threads = p.backend.threads;
    p.bvh = cache.bvh(p.flat, config);
    p.meshBvhs = cache.meshBvhs(*p.flat, config);
  }
}

/// What an integrator was compiled and its scene uploaded for.
bool sameIntegrator(const Prepared& a, const Prepared& b) {
  return integratorName(a.settings) == integratorName(b.settings) && rowFor(a.features) == rowFor(b.features) &&
         a.settings.accel == b.settings.accel &&
         (!(a.features & feature::tree) || treeConfig(a.settings) == treeConfig(b.settings));
}

}  // namespace

std::string integratorName(const Settings& s) {
  bool const firstHit = s.aov != "radiance" && s.aov != "photon-count" && s.aov != "gather-radius";
  return firstHit ? "aov" : s.mode;
}

FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& s) {
  FeatureBits bits = featuresOf(flat, camera);
  bits |= structureFor(flat.hitCount(), s);
  bool const sppm = integratorName(s) == "sppm";
  if (sppm && (bits & feature::lights) && (bits & (feature::diffuse | feature::glossy))) bits |= feature::photons;
  if ((bits & feature::photons) && s.gather == "nearest") bits |= feature::nearest;
  return bits;
}

Prepared prepare(const Scene& scene, const Settings& settings, const BackendChoice& backend, bool onGpu,
                 SceneCache& cache) {
  Prepared p;
  p.flat = cache.flat(scene.camera);
  p.camera = p.flat->inFrame(scene.camera);
  p.film = scene.film;
  p.backend = backend;
  p.onGpu = onGpu;
  resolveAll(p, settings);
  requireMemory(p);
  buildStructures(p, cache);
  resolveRadius(p);
  return p;
}

std::optional<Prepared> prepareAgain(const Prepared& before, const CameraDesc& camera, const Settings& settings) {
  Prepared p = before;
  p.camera = before.flat->inFrame(camera);
  resolveAll(p, settings);
  if (!sameIntegrator(p, before) || reachOf(p.flat->bounds, p.camera.position) > p.flat->reach) return {};
  requireMemory(p, &before);
  resolveRadius(p);
  return p;
}

double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor) {
  double const i = double(iteration);
  double const logRatio = std::lgamma(i + alpha) - std::lgamma(1 + alpha) - std::lgamma(i + 1);
  return std::max(firstRadius * std::exp(0.5 * logRatio), floor);
}

}  // namespace ropelight
