#pragma once
// Photon paths: emission, specular and diffuse bounces with Russian roulette, deposits at diffuse surfaces.

#include "render/backend/tally.h"
#include "render/kernels/frame_view.h"
#include "render/light/lights.h"
#include "render/photons/photon_store.h"

namespace ropelight::RL_TARGET {

/// Traces one path and calls deposit(number, position, power, w) for each of its photons; w: unit,
/// to where it came from. Returns how many there are.
template <FeatureBits F, class Deposit>
RL_HD inline std::uint32_t tracePhotonPath(const FrameView& frame, std::uint64_t path, Real pathsPerIteration,
                                           Deposit&& deposit, Tally& tally) {
  Sampler sampler = frame.photonSampler(path);
  Real const uLight = sampler.next1();
  Vec2 const uPoint = sampler.next2(), uDirection = sampler.next2();
  bool const aimed = frame.photonClass == PhotonClass::caustic;
  Emitted const start = aimed
                            ? emitAimed<F>(frame.scene, uLight, sampler.next1(), uPoint, uDirection, pathsPerIteration)
                            : emitPhoton<F>(frame.scene, uLight, uPoint, uDirection, pathsPerIteration);
  Rgb flux = start.flux;
  if (aimed && isBlack(flux)) return 0;
  Flight flight = depart<F>(frame.scene, start.surface, start.direction);
  if (hiddenAtStart<F>(frame.scene, flight)) return 0;
  std::uint32_t count = 0;
  bool specularSoFar = true;
  for (int edges = 1; edges < frame.maxDepth; ++edges) {
    ++tally.rays;
    Surface s;
    if (!meet<F>(frame.scene, flight, s)) return count;
    if (!isFinite(s.p.x + s.p.y + s.p.z +
                  Real(flux.x + flux.y + flux.z))) {  // it would be in no cell, and poison a disc
      ++tally.nonFinitePhotons;
      return count;
    }
    Vec2 const direction = sampler.next2(), u = sampler.next2();
    bool goesOn = false;
    bsdfAt<F>(frame.scene, s, [&](const auto& bsdf) {
      Frame const local(s.n);
      Vec3 const wo = local.toLocal(-flight.ray.direction);
      if (bsdf.lobes() & lobe::gathered) {
        // One edge from the light is direct light, which shadow rays have unless photons are to carry it.
        bool const caustic = specularSoFar && edges > 1, direct = edges == 1;
        if (frame.stores(caustic) && !(direct && (frame.shadowRays || frame.indirectOnly)))
          deposit(count++, PhotonPosition{s.p, packDirection(wo.z < 0 ? -s.n : s.n)},
                  PhotonPower{flux, std::uint32_t(edges) | (caustic ? PhotonPower::causticBit : 0u)},
                  -flight.ray.direction);
        specularSoFar = false;
        if (aimed) return;  // what it lights next is for the others
      }
      BsdfSample const b = bsdf.sample(wo, u.x, direction, Transport::flux);
      Rgb const next = flux * b.weight;
      Real const survival = rouletteSurvival(Real(maxComponent(next) / maxComponent(flux)), edges, b.specular());
      goesOn = survival > u.y;
      flux = survival < 1 ? next * float(1 / survival) : next;
      flight = depart<F>(frame.scene, s, normalize(local.toWorld(b.wi)));
    });
    if (!goesOn) return count;
  }
  if (frame.maxDepth == hardDepthLimit) ++tally.truncated;
  return count;
}

template <FeatureBits F>
struct TracePhotons;

struct TracePhotonsArgs {
  template <FeatureBits F>
  using Stage = TracePhotons<F>;
  static constexpr const char* name = "TracePhotons";
  static constexpr std::uint32_t grain = 512;

  FrameView frame;
  PhotonStore store;
  std::uint64_t firstPath = 0;
  Real pathsPerIteration = 1;
};

template <FeatureBits F>
struct TracePhotons : TracePhotonsArgs {
  RL_HD void operator()(std::uint32_t path, Tally& tally) const {
    std::uint32_t const count = tracePhotonPath<F>(
        frame, firstPath + path, pathsPerIteration,
        [&](std::uint32_t deposit, const PhotonPosition& position, const PhotonPower& power, Vec3 w) {
          if (deposit >= store.stripe) return;
          store.put<F>(deposit * store.paths + path, Photon{position, power}, w);
        },
        tally);
    bool const longer = count > store.stripe;
    store.counts[path] = DepositCount{count, longer ? count - store.stripe : 0, longer ? 1u : 0u};
  }
};

/// Lists the paths with a tail, in order.
struct ListLongPaths {
  static constexpr const char* name = "ListLongPaths";
  static constexpr std::uint32_t grain = 8192;

  PhotonStore store;

  RL_HD void operator()(std::uint32_t path, Tally&) const {
    if (store.counts[path].longer) store.longPaths[store.offsets[path].longer] = path;
  }
};

/// Halts the iteration where its photons do not fit.
struct CheckRoom {
  static constexpr const char* name = "CheckRoom";
  static constexpr std::uint32_t grain = 1;

  PhotonStore store;

  RL_HD void operator()(std::uint32_t, Tally&) const {
    DepositCount const total = store.offsets[store.paths];
    IterationState& s = store.state[0];
    s.chunkPhotons = total.all;
    if (!store.caustics) s.otherPhotons = total.all;
    s.pending += total.all;
    if (total.all <= store.photonCapacity && total.tail <= store.tailCapacity) return;
    s.halt = 1;
    s.photonsNeeded = s.photonsNeeded > total.all ? s.photonsNeeded : total.all;
    s.tailNeeded = s.tailNeeded > total.tail ? s.tailNeeded : total.tail;
  }
};

/// Traces the long paths again for the deposits that had no slot. `i` counts long paths; more threads than those idle.
template <FeatureBits F>
struct TraceTails;

struct TraceTailsArgs {
  template <FeatureBits F>
  using Stage = TraceTails<F>;
  static constexpr const char* name = "TraceTails";
  static constexpr std::uint32_t grain = 128;

  FrameView frame;
  PhotonStore store;
  std::uint64_t firstPath = 0;
  Real pathsPerIteration = 1;
};

template <FeatureBits F>
struct TraceTails : TraceTailsArgs {
  RL_HD void operator()(std::uint32_t i, Tally& tally) const {
    if (store.state[0].halt || i >= store.offsets[store.paths].longer) return;
    std::uint32_t const path = store.longPaths[i];
    Tally again;  // the first tracing has counted truncation
    tracePhotonPath<F>(
        frame, firstPath + path, pathsPerIteration,
        [&](std::uint32_t deposit, const PhotonPosition& position, const PhotonPower& power, Vec3 w) {
          if (deposit < store.stripe || deposit >= store.counts[path].all) return;
          store.put<F>(store.slotOf(path, deposit), Photon{position, power}, w);
        },
        again);
    tally.rays += again.rays;
  }
};

}  // namespace ropelight::RL_TARGET
