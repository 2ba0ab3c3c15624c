#pragma once
// Unidirectional path tracing with next-event estimation, multiple importance sampling and Russian roulette.

#include "render/kernels/direct.h"

namespace ropelight::RL_TARGET {

template <FeatureBits F>
struct TracePath;

struct TracePathArgs {
  template <FeatureBits F>
  using Stage = TracePath<F>;
  static constexpr const char* name = "TracePath";
  static constexpr std::uint32_t grain = 256;

  FrameView frame;
  Span<Rgb> radiance;
};

template <FeatureBits F>
struct TracePath : TracePathArgs {
  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    int x, y;
    radiance[slot] = Rgb(0.0f);
    if (!frame.pixelOf(slot, x, y)) return;
    Sampler sampler = frame.cameraSampler(x, y);
    Ray const ray = frame.cameraRay<F>(x, y, sampler);
    Rgb const sum = trace(Flight{ray, Hit{}}, sampler, tally);
    radiance[slot] = sum;
    if (!isFinite(Vec3(sum))) ++tally.nonFinitePaths;
  }

 private:
  struct State {
    Rgb throughput{1.0f};
    Real radianceScale = 1;
    Real pdf = 0;         ///< of the last direction; 0 after a specular bounce or at the camera
    Vec3 from{0};         ///< where it was sampled
    int diffuseHits = 0;  ///< non-specular vertices so far
  };

  RL_HD Rgb trace(Flight flight, Sampler& sampler, Tally& tally) const {
    Rgb sum(0.0f);
    State state;
    for (int edges = 1; edges <= frame.maxDepth; ++edges) {
      ++tally.rays;
      Surface s;
      if (!meet<F>(frame.scene, flight, s)) return sum + state.throughput * arrivingFromBeyond(flight, state);
      Vec3 const w = flight.ray.direction;
      sum += state.throughput * arrivingEmission(s, w, state);
      bool goesOn = false;
      PendingLight direct;
      bsdfAt<F>(frame.scene, s, [&](const auto& bsdf) {
        Frame const local(s.n);
        Vec3 const wo = local.toLocal(-w);
        if (bsdf.lobes() & lobe::gathered) {
          if (edges < frame.maxDepth) direct = nextEvent(bsdf, s, local, wo, sampler, state);
          ++state.diffuseHits;
        }
        goesOn = bounce(bsdf, s, local, wo, sampler, state, edges, flight);
      });
      if (direct.wanted) sum += arriving<F>(frame, direct, tally);
      if (!goesOn) return sum;
    }
    if (frame.maxDepth == hardDepthLimit) ++tally.truncated;
    return sum;
  }

  /// Emission that the path ran into, weighted against the light sample that could have found it. `indirectOnly` leaves
  /// out what reaches the eye before a diffuse surface and what the first diffuse surface sees directly.
  RL_HD Rgb arrivingEmission(const Surface& s, Vec3 w, const State& state) const {
    Rgb const light = emitted(frame.scene, s, -w);
    if (isBlack(light)) return light;
    if (leftOut(state)) return Rgb(0.0f);
    if (state.pdf == 0) return light;
    return light * float(powerHeuristic(state.pdf, lightPdf<F>(frame.scene, state.from, s, w)));
  }

  RL_HD bool leftOut(const State& state) const {
    return frame.indirectOnly && (state.diffuseHits == 0 || (state.diffuseHits == 1 && state.pdf > 0));
  }

  /// The same of a ray that leaves the scene.
  RL_HD Rgb arrivingFromBeyond(const Flight& flight, const State& state) const {
    if constexpr ((F & feature::environment) == 0) return Rgb(0.0f);
    if (leftOut(state)) return Rgb(0.0f);
    Beyond const sky = beyondScene<F>(frame.scene, state.from, flight.ray.direction);
    return state.pdf == 0 ? sky.radiance : sky.radiance * float(powerHeuristic(state.pdf, sky.pdf));
  }

  /// Scaled by the throughput so far, since the bounce follows before the shadow ray.
  template <class Bsdf>
  RL_HD PendingLight nextEvent(const Bsdf& bsdf, const Surface& s, const Frame& local, Vec3 wo, Sampler& sampler,
                               const State& state) const {
    if constexpr ((F & feature::lights) == 0) return PendingLight{};
    if (frame.scene.lights.empty()) return PendingLight{};
    PendingLight direct = sampleDirect<F>(frame, s, local, bsdf, wo, sampler, true);
    bool const leftOut = frame.indirectOnly && state.diffuseHits == 0;
    direct.light = leftOut ? Rgb(0.0f) : state.throughput * direct.light;
    return direct;
  }

  template <class Bsdf>
  RL_HD bool bounce(const Bsdf& bsdf, const Surface& s, const Frame& local, Vec3 wo, Sampler& sampler, State& state,
                    int edges, Flight& flight) const {
    Vec2 const direction = sampler.next2(), u = sampler.next2();
    BsdfSample const b = bsdf.sample(wo, u.x, direction, Transport::radiance);
    state.throughput *= b.weight;
    state.radianceScale *= b.radianceScale;
    state.pdf = b.specular() ? Real(0) : b.pdf;
    state.from = s.p;
    if (edges > 3) {
      Real const survival =
          rouletteSurvival(Real(maxComponent(state.throughput)) / state.radianceScale, edges, b.specular());
      if (!(u.y < survival)) return false;
      state.throughput *= float(1 / survival);
    }
    flight = depart<F>(frame.scene, s, normalize(local.toWorld(b.wi)));
    return !isBlack(state.throughput);
  }
};

}  // namespace ropelight::RL_TARGET
