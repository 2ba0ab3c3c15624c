#pragma once
// What every stage of one iteration knows, and the order in which pixels are worked on.

#include "render/camera/camera.h"
#include "render/intersection/flight.h"
#include "render/sampler/sampler.h"
#include "render/settings/settings.h"

namespace ropelight::RL_TARGET {

/// The seed of camera paths: beyond 2³² iterations their numbers must not begin again.
constexpr std::uint64_t cameraSeedOf(std::uint64_t seed, std::uint64_t iteration) {
  return seed ^ ((iteration >> 32) * 0x9E3779B97F4A7C15ull);
}

struct FrameView {
  SceneView scene;
  CameraView camera;
  int width = 0, height = 0;
  int sampler = 0;
  int maxDepth = 0;  ///< edges of a whole path
  std::uint64_t seed = 0;
  std::uint64_t cameraSeed = 0;  ///< another one every 2³² iterations
  std::uint32_t iteration = 0;   ///< from 0, modulo 2³²
  bool shadowRays = true;        ///< direct light by shadow rays; else by photons
  PhotonClass photonClass = PhotonClass::every;
  bool indirectOnly = false;
  bool dark = false;  ///< camera paths carry no light: something else is wanted of their ends

  /// Whether photons of this kind are stored.
  RL_HD bool stores(bool caustic) const {
    return photonClass == PhotonClass::every || caustic == (photonClass == PhotonClass::caustic);
  }

  /// Slots for pixels, in tiles of 8×4 so that neighbours in memory and in a warp are neighbours in the image.
  RL_HD std::uint32_t slots() const { return std::uint32_t((width + 7) / 8) * std::uint32_t((height + 3) / 4) * 32; }

  /// False where the slot lies outside the image.
  RL_HD bool pixelOf(std::uint32_t slot, int& x, int& y) const {
    std::uint32_t const tile = slot / 32, lane = slot % 32;
    std::uint32_t const across = std::uint32_t((width + 7) / 8);
    x = int(8 * (tile % across) + (lane & 7));
    y = int(4 * (tile / across) + (lane >> 3));
    return x < width && y < height;
  }

  RL_HD Sampler cameraSampler(int x, int y) const {
    return Sampler(sampler, cameraSeed, Stream::camera, std::uint32_t(y * width + x), iteration);
  }

  RL_HD Sampler photonSampler(std::uint64_t path) const {
    Stream const stream = photonClass == PhotonClass::caustic ? Stream::caustic : Stream::photon;
    return Sampler(sampler, seed, stream, std::uint32_t(path >> 32), std::uint32_t(path));
  }

  template <FeatureBits F>
  RL_HD Ray cameraRay(int x, int y, Sampler& s) const {
    Vec2 const jitter = s.next2();
    if constexpr ((F & feature::lens) != 0)
      if (camera.thinLens) return camera.generate(Real(x) + jitter.x, Real(y) + jitter.y, s.next2());
    return camera.generate(Real(x) + jitter.x, Real(y) + jitter.y);
  }
};

/// Survival probability of Russian roulette that keeps a path's weight: what the bounce has kept. Lossless bounces end
/// too, in the end: light caught inside glass after some 64, light in white rooms after some 1024. The cap approaches 1
/// so fast that paths of length n have weights of O(n²) and O(n): the variance stays finite at every albedo below 1,
/// which no constant cap below albedo² would leave it.
RL_HD inline Real rouletteSurvival(Real kept, int edges, bool specular) {
  if (faulty(Fault::roulette)) return minOf(kept, edges > 64 ? Real(0.95) : Real(1));
  if (faulty(Fault::depthLimit) && edges >= 256) return 0;
  int const start = specular ? 64 : 1024;
  return edges > start ? minOf(kept, 1 - Real(specular ? 2 : 1) / Real(edges)) : minOf(kept, Real(1));
}

}  // namespace ropelight::RL_TARGET
