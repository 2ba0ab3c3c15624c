#pragma once
// What a window shows: the film's mean and the latest photons, laid out for GL buffers.

#include "accel/photon_grid/photon_grid.h"
#include "render/backend/tally.h"
#include "render/kernels/commit.h"
#include "render/kernels/frame_view.h"
#include "render/kernels/photon_point.h"

namespace ropelight::RL_TARGET {

struct DisplayPixel {
  float r, g, b, a;
};

struct ResolveFilm {
  static constexpr const char* name = "ResolveFilm";
  static constexpr std::uint32_t grain = 8192;

  FrameView frame;
  std::uint64_t samples;  ///< of every pixel
  Span<const glm::dvec3> sum;
  Span<const std::uint32_t> missing;
  Span<DisplayPixel> pixels;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    int x, y;
    if (!frame.pixelOf(slot, x, y)) return;
    Rgb const mean = meanOf(sum[slot], samples, missing[slot]);
    pixels[std::uint32_t(y) * std::uint32_t(frame.width) + std::uint32_t(x)] = {mean.x, mean.y, mean.z, 1};
  }
};

/// Point i of `count`, evenly chosen from `photons`.
struct ResolvePhotons {
  static constexpr const char* name = "ResolvePhotons";
  static constexpr std::uint32_t grain = 8192;

  Span<const PhotonPosition> positions;
  Span<const PhotonPower> powers;
  std::uint32_t photons, count;
  Span<PhotonPoint> points;

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    std::uint32_t const k = std::uint32_t(std::uint64_t(i) * photons / count);
    Vec3 const p = positions[k].p;
    PhotonPower const w = powers[k];
    points[i] = {
        {float(p.x), float(p.y), float(p.z)}, {w.flux.x, w.flux.y, w.flux.z}, w.edges(), w.caustic() ? 1u : 0u};
  }
};

}  // namespace ropelight::RL_TARGET
