#include "render/prepare/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"
#include "render/launch/rows.h"
#include "render/prepare/first_radius.h"
#include "render/prepare/memory_need.h"
#include "render/prepare/structure_choice.h"

namespace ropelight {
namespace {

void requireConsistent(const Settings& s) {
  if (sourceOf(s.aov) == AovSource::gather && s.mode != Mode::sppm)
    throw Error(fmt::format("--aov {}: only --mode sppm gathers photons", nameOf(s.aov)), ExitCode::usage);
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
Accel accelOf(FeatureBits features) {
  if (features & feature::shortStack) return Accel::shortStack;
  if (features & feature::tree) return Accel::tree;
  return (features & feature::bvh) ? Accel::bvh : Accel::brute;
}

/// All but the structure and the first radius.
void resolveAll(Prepared& p, const Settings& requested) {
  requireConsistent(requested);
  p.requested = p.settings = requested;
  resolve(p.film, p.flat->primitiveCount(), p.settings);
  p.features = featuresOf(*p.flat, p.camera, p.settings);
  p.settings.accel = accelOf(p.features);
}

void resolveRadius(Prepared& p) {
  if (p.features & feature::photons) resolvePhotons(p);
}

KdSplit splitOf(SplitBy by) {
  switch (by) {
    case SplitBy::sah:
      return KdSplit::sah;
    case SplitBy::sweep:
      return KdSplit::sweep;
    case SplitBy::midpoint:
      return KdSplit::midpoint;
  }
  throw Error("a split without a rule", ExitCode::internal);
}

KdConfig treeConfig(const Settings& s, int threads = 0) {
  KdConfig config;
  config.threads = threads;
  config.split = splitOf(s.split);
  config.bins = s.bins;
  config.leafSize = s.leafSize;
  config.maxDepth = s.treeDepth;
  return config;
}

/// things: what testing all of them would test.
FeatureBits structureFor(std::uint32_t things, const Settings& s) {
  if (things == 0) return 0;
  switch (s.accel) {
    case Accel::automatic:
      return things > bruteForceLimit ? feature::bvh : 0;
    case Accel::bvh:
      return feature::bvh;
    case Accel::tree:
      return feature::tree;
    case Accel::shortStack:
      return feature::tree | feature::shortStack;
    case Accel::brute:
      return 0;
  }
  throw Error("an acceleration without a structure", ExitCode::internal);
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

void findTargets(Prepared& p) {
  if ((p.features & feature::photons) && (p.features & feature::quads) && !p.planes)
    p.planes = std::make_shared<const PlaneParts>(planeParts(*p.flat));
  if ((p.features & feature::caustics) && !p.targets)
    p.targets = std::make_shared<const std::vector<SpecularTarget>>(specularTargets(*p.flat));
}

/// What an integrator was compiled and its scene uploaded for.
bool sameIntegrator(const Prepared& a, const Prepared& b) {
  return integratorOf(a.settings) == integratorOf(b.settings) && rowFor(a.features) == rowFor(b.features) &&
         (a.features & feature::caustics) == (b.features & feature::caustics) && a.settings.accel == b.settings.accel &&
         (!(a.features & feature::tree) || treeConfig(a.settings) == treeConfig(b.settings));
}

}  // namespace

IntegratorKind integratorOf(const Settings& s) {
  if (sourceOf(s.aov) == AovSource::firstHit) return IntegratorKind::aov;
  switch (s.mode) {
    case Mode::ray:
      return IntegratorKind::ray;
    case Mode::path:
      return IntegratorKind::path;
    case Mode::sppm:
      return IntegratorKind::sppm;
  }
  throw Error("a mode without an integrator", ExitCode::internal);
}

FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& s) {
  FeatureBits bits = featuresOf(flat, camera);
  bits |= structureFor(flat.hitCount(), s);
  bool const sppm = integratorOf(s) == IntegratorKind::sppm;
  if (sppm && (bits & feature::lights) && (bits & (feature::diffuse | feature::glossy))) bits |= feature::photons;
  if ((bits & feature::photons) && s.gather == GatherBy::nearest) bits |= feature::nearest;
  bool const aimed = s.caustics == Caustics::aimed && s.gather == GatherBy::radius;
  if ((bits & feature::photons) && (bits & (feature::mirror | feature::dielectric)) && aimed) bits |= feature::caustics;
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
  findTargets(p);
  resolveRadius(p);
  return p;
}

std::optional<Prepared> prepareAgain(const Prepared& before, const CameraDesc& camera, const Settings& settings) {
  Prepared p = before;
  p.camera = before.flat->inFrame(camera);
  resolveAll(p, settings);
  if (!sameIntegrator(p, before) || reachOf(p.flat->bounds, p.camera.position) > p.flat->reach) return {};
  requireMemory(p, &before);
  findTargets(p);
  resolveRadius(p);
  return p;
}

double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor) {
  double const i = double(iteration);
  double const logRatio = std::lgamma(i + alpha) - std::lgamma(1 + alpha) - std::lgamma(i + 1);
  return std::max(firstRadius * std::exp(0.5 * logRatio), floor);
}

}  // namespace ropelight
