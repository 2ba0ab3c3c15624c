#pragma once
// Camera rays through specular bounces to the first diffuse surface: emission on the way, direct light there, and the
// point at which photons will be gathered.

#include "accel/photon_grid/photon_grid.h"
#include "render/kernels/direct.h"

namespace ropelight::RL_TARGET {

/// n: unit normal on the side that is looked at. weight: throughput · f; zero where nothing is to be gathered.
/// Aligned so that a GPU reads one in three words.
struct alignas(16) GatherPoint {
  Vec3 p;
  std::uint32_t edges;  ///< of the path from the camera to here
  Vec3 n;
  std::uint32_t packedNormal;
  Rgb weight;
  std::uint32_t surface = noPrimitive;  ///< the primitive
};

/// What a gather point needs besides, where photons count by their direction. back: unit, towards the camera.
struct GlossyPoint {
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  Vec3 back;
  std::uint32_t material = none;  ///< none: Lambertian, all is in the gather point's weight
  bool inner = false;             ///< seen from the side that the surface's normal points away from
};

template <FeatureBits F>
struct TraceCamera;

struct TraceCameraArgs {
  template <FeatureBits F>
  using Stage = TraceCamera<F>;
  static constexpr const char* name = "TraceCamera";
  static constexpr std::uint32_t grain = 512;

  FrameView frame;
  Span<Rgb> radiance;
  Span<GatherPoint> points;  ///< empty where no photons are gathered
  Span<GlossyPoint> glossy;  ///< empty but with feature::glossy
};

template <FeatureBits F>
struct TraceCamera : TraceCameraArgs {
  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    int x, y;
    Chain chain;
    bool arrived = false;
    if (frame.pixelOf(slot, x, y)) {
      Sampler sampler = frame.cameraSampler(x, y);
      Ray const ray = frame.cameraRay<F>(x, y, sampler);
      arrived = trace(Flight{ray, Hit{}}, sampler, slot, chain, tally);
    }
    radiance[slot] = chain.sum;
    if (!isFinite(Vec3(chain.sum))) ++tally.nonFinitePaths;
    if (!arrived && !points.empty()) points[slot] = GatherPoint{};
  }

 private:
  /// What a path carries until it arrives at a surface that is not specular.
  struct Chain {
    Rgb sum{0.0f}, throughput{1.0f};
    Real radianceScale = 1;
    int edges = 0;
  };

  /// Whether the path arrived. What comes after the arrival stands outside the loop: within it, the results would hold
  /// registers while rays are traced.
  RL_HD bool trace(Flight flight, Sampler& sampler, std::uint32_t slot, Chain& chain, Tally& tally) const {
    Surface s;
    Vec3 back;
    if (!follow(flight, sampler, chain, s, back, tally)) return false;
    chain.sum += arrive(s, back, sampler, chain, slot, tally);
    return true;
  }

  RL_HD bool follow(Flight& flight, Sampler& sampler, Chain& chain, Surface& s, Vec3& back, Tally& tally) const {
    while (chain.edges < frame.maxDepth) {
      ++chain.edges;
      ++tally.rays;
      if (!meet<F>(frame.scene, flight, s)) {
        if constexpr ((F & feature::environment) != 0) addBeyond(flight, chain);
        return false;
      }
      back = -flight.ray.direction;
      if (!frame.indirectOnly && !frame.dark) chain.sum += chain.throughput * emitted(frame.scene, s, back);
      if (!frame.scene.materials[s.material].specular()) return true;
      bool goesOn = false;
      bsdfAt<F>(frame.scene, s, [&](const auto& bsdf) {
        if constexpr ((std::decay_t<decltype(bsdf)>::possibleLobes & lobe::specular) != 0)
          goesOn = bounce(bsdf, s, back, sampler, chain, flight);
      });
      if (!goesOn) return false;
    }
    if (frame.maxDepth == hardDepthLimit) ++tally.truncated;
    return false;
  }

  RL_HD void addBeyond(const Flight& flight, Chain& chain) const {
    if (frame.indirectOnly || frame.dark) return;
    chain.sum += chain.throughput * beyondScene<F>(frame.scene, flight.ray.origin, flight.ray.direction).radiance;
  }

  /// Direct light; the gather point goes to its slot.
  RL_HD Rgb arrive(const Surface& s, Vec3 back, Sampler& sampler, const Chain& chain, std::uint32_t slot,
                   Tally& tally) const {
    PendingLight direct;
    bsdfAt<F>(frame.scene, s, [&](const auto& bsdf) {
      using Bsdf = std::decay_t<decltype(bsdf)>;
      if constexpr ((Bsdf::possibleLobes & lobe::gathered) != 0) {
        Frame const local(s.n);
        Vec3 const wo = local.toLocal(back);
        if (wantsDirect(chain)) direct = sampleDirect<F>(frame, s, local, bsdf, wo, sampler, false);
        if (!points.empty()) putPoint(bsdf, s, wo, back, chain, slot);
      }
    });
    return direct.wanted ? chain.throughput * arriving<F>(frame, direct, tally) : Rgb(0.0f);
  }

  /// A Lambertian surface weighs all photons alike; a glossy one is asked for each of them.
  template <class Bsdf>
  RL_HD void putPoint(const Bsdf& bsdf, const Surface& s, Vec3 wo, Vec3 back, const Chain& chain,
                      std::uint32_t slot) const {
    Vec3 const n = wo.z < 0 ? -s.n : s.n;
    GatherPoint point{s.p, std::uint32_t(chain.edges), n, packDirection(n), chain.throughput, s.primitive};
    bool perPhoton = false;
    if constexpr ((F & feature::glossy) != 0) {
      perPhoton = (bsdf.lobes() & lobe::glossy) != 0;
      if (!glossy.empty()) glossy[slot] = GlossyPoint{back, perPhoton ? s.material : GlossyPoint::none, wo.z < 0};
    }
    if (!perPhoton) point.weight *= bsdf.eval(wo, Vec3(0, 0, copysign(Real(1), wo.z)));
    points[slot] = point;
  }

  RL_HD bool wantsDirect(const Chain& chain) const {
    if constexpr ((F & feature::lights) == 0) return false;
    return frame.shadowRays && !frame.indirectOnly && !frame.dark && !frame.scene.lights.empty() &&
           chain.edges < frame.maxDepth;
  }

  /// False where Russian roulette ends a long chain of absorbing bounces.
  template <class Bsdf>
  RL_HD bool bounce(const Bsdf& bsdf, const Surface& s, Vec3 back, Sampler& sampler, Chain& chain,
                    Flight& flight) const {
    Frame const local(s.n);
    Vec2 const u = sampler.next2();
    BsdfSample const b = bsdf.sample(local.toLocal(back), u.x, Vec2(0), Transport::radiance);
    chain.throughput *= b.weight;
    chain.radianceScale *= b.radianceScale;
    Real const survival =
        rouletteSurvival(Real(maxComponent(chain.throughput)) / chain.radianceScale, chain.edges, true);
    if (chain.edges > 8 && survival < 1) {
      if (u.y >= survival) return false;
      chain.throughput *= float(1 / survival);
    }
    flight = depart<F>(frame.scene, s, normalize(local.toWorld(b.wi)));
    return !isBlack(chain.throughput);
  }
};

}  // namespace ropelight::RL_TARGET
