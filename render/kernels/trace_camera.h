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
};

template <FeatureBits F>
struct TraceCamera : TraceCameraArgs {
  RL_HD void operator()(std::uint32_t slot, Tally& tally) const {
    int x, y;
    Rgb sum(0.0f);
    GatherPoint point{};
    if (frame.pixelOf(slot, x, y)) {
      Sampler sampler = frame.cameraSampler(x, y);
      Ray const ray = frame.cameraRay<F>(x, y, sampler);
      sum = trace(Flight{ray, Hit{}}, sampler, point, tally);
    }
    radiance[slot] = sum;
    if (!points.empty()) points[slot] = point;
  }

 private:
  RL_HD Rgb trace(Flight flight, Sampler& sampler, GatherPoint& point, Tally& tally) const {
    Rgb sum(0.0f), throughput(1.0f);
    Real radianceScale = 1;
    for (int edges = 1; edges <= frame.maxDepth; ++edges) {
      ++tally.rays;
      Surface s;
      if (!meet<F>(frame.scene, flight, s)) return sum;
      Vec3 const back = -flight.ray.direction;
      if (!frame.indirectOnly && !frame.dark) sum += throughput * emitted(frame.scene, s, back);
      bool goesOn = false;
      visitBsdf<F>(frame.scene.materials[s.material], [&](const auto& bsdf) {
        Frame const local(s.n);
        Vec3 const wo = local.toLocal(back);
        if constexpr (std::decay_t<decltype(bsdf)>::specular) {
          goesOn = bounce(bsdf, s, local, wo, sampler, throughput, radianceScale, edges, flight);
        } else {
          sum += throughput * arrive(bsdf, s, local, wo, sampler, edges, tally);
          Vec3 const n = wo.z < 0 ? -s.n : s.n;
          point = GatherPoint{s.p, std::uint32_t(edges), n, packDirection(n),
                              throughput * bsdf.eval(wo, Vec3(0, 0, copysign(Real(1), wo.z)))};
        }
      });
      if (!goesOn) return sum;
    }
    if (frame.maxDepth == hardDepthLimit) ++tally.truncated;
    return sum;
  }

  template <class Bsdf>
  RL_HD Rgb arrive(const Bsdf& bsdf, const Surface& s, const Frame& local, Vec3 wo, Sampler& sampler, int edges,
                   Tally& tally) const {
    if constexpr ((F & feature::lights) == 0) return Rgb(0.0f);
    if (!frame.shadowRays || frame.indirectOnly || frame.dark || frame.scene.lights.empty() || edges >= frame.maxDepth)
      return Rgb(0.0f);
    return directLight<F>(frame, s, local, bsdf, wo, sampler, false, tally);
  }

  /// False where Russian roulette ends a long chain of absorbing bounces.
  template <class Bsdf>
  RL_HD bool bounce(const Bsdf& bsdf, const Surface& s, const Frame& local, Vec3 wo, Sampler& sampler, Rgb& throughput,
                    Real& radianceScale, int edges, Flight& flight) const {
    Vec2 const u = sampler.next2();
    BsdfSample const b = bsdf.sample(wo, u.x, Vec2(0), Transport::radiance);
    throughput *= b.weight;
    radianceScale *= b.radianceScale;
    Real const survival = rouletteSurvival(Real(maxComponent(throughput)) / radianceScale, edges);
    if (edges > 8 && survival < 1) {
      if (u.y >= survival) return false;
      throughput *= float(1 / survival);
    }
    flight = depart<F>(frame.scene, s, normalize(local.toWorld(b.wi)));
    return !isBlack(throughput);
  }
};

}  // namespace ropelight::RL_TARGET
