#pragma once
// Direct light at a surface by one shadow ray.

#include "render/backend/tally.h"
#include "render/kernels/frame_view.h"
#include "render/light/lights.h"

namespace ropelight::RL_TARGET {

RL_HD inline Real powerHeuristic(Real a, Real b) {
  if (a == infinity) return 1;
  return a > b ? 1 / (1 + square(b / a)) : square(a / b) / (1 + square(a / b));  // a² never overflows
}

/// Light from a sampled point, and the shadow ray that decides whether it arrives. It is traced after the BSDF has been
/// dispatched, so that traversal is compiled once and not once for each BSDF.
struct PendingLight {
  ShadowRay shadow;
  Rgb light{0.0f};      ///< f·L·cos/pdf if nothing is in the way
  bool wanted = false;  ///< whether there is anything to be traced for
};

/// One light sample at a surface, weighted against BSDF sampling where `mis` is set (Veach & Guibas 1995).
template <FeatureBits F, class Bsdf>
RL_HD inline PendingLight sampleDirect(const FrameView& frame, const Surface& s, const Frame& local, const Bsdf& bsdf,
                                       Vec3 wo, Sampler& sampler, bool mis) {
  PendingLight direct;
  Real const uLight = sampler.next1();
  DirectSample const light = sampleLight<F>(frame.scene, s, uLight, sampler.next2());
  if (light.pdf == 0) return direct;
  Vec3 const wi = local.toLocal(light.wi);
  Rgb const f = bsdf.eval(wo, wi);
  if (isBlack(f)) return direct;
  Real const weight = mis ? powerHeuristic(light.pdf, bsdf.pdf(wo, wi)) : Real(1);
  direct.light = f * light.radiance * float(abs(wi.z) * weight / light.pdf);
  direct.shadow = shadowRay<F>(frame.scene, s, light);
  direct.wanted = true;
  return direct;
}

/// What of it arrives, where it is wanted.
template <FeatureBits F>
RL_HD inline Rgb arriving(const FrameView& frame, const PendingLight& direct, Tally& tally) {
  ++tally.shadowRays;
  return occluded<F>(frame.scene, direct.shadow) ? Rgb(0.0f) : direct.light;
}

}  // namespace ropelight::RL_TARGET
