#pragma once
// Gathering where surfaces are glossy: the BSDF is evaluated for every photon, by the direction that it came from.
// Lambertian gather points keep their one weight.

#include "render/bsdf/material.h"
#include "render/core/frame.h"
#include "render/kernels/gather.h"

namespace ropelight::RL_TARGET {

template <FeatureBits F>
struct GatherGlossy;

struct GatherGlossyArgs {
  template <FeatureBits F>
  using Stage = GatherGlossy<F>;
  static constexpr const char* name = "GatherGlossy";
  static constexpr std::uint32_t grain = 512;

  GatherView view;  ///< its grid has directions
  Span<const Material> materials;
  Span<const GatherPoint> points;
  Span<const GlossyPoint> glossy;
  Span<Rgb> radiance;
};

template <FeatureBits F>
struct GatherGlossy : GatherGlossyArgs {
  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (isBlack(g.weight)) return;
    GlossyPoint const seen = glossy[slot];
    if (seen.material == GlossyPoint::none)
      putGathering(radiance[slot], g, gatherDisc(view, g), Gathered::radiance);
    else
      radiance[slot] += g.weight * reflected(g, seen);
  }

 private:
  /// Σ f(wo, wi)·Φ over the disc's area.
  RL_HD Rgb reflected(const GatherPoint& g, const GlossyPoint& seen) const {
    Rgb sum(0.0f);
    GatherView const here = view.on(g);
    Frame const local(seen.inner ? -g.n : g.n);
    Vec3 const wo = local.toLocal(seen.back);
    visitBsdf<F>(materials[seen.material], [&](const auto& bsdf) {
      here.forEachOnDisc(g, square(here.radius), [&](std::uint32_t k, Real, const PhotonPower& power) {
        sum += bsdf.eval(wo, local.toLocal(unpackDirection(view.grid.directions[k]))) * power.flux;
      });
    });
    Real const radius2 = square(here.radius);
    return sum * float(invPi / (radius2 * here.share(g, radius2)));
  }
};

}  // namespace ropelight::RL_TARGET
