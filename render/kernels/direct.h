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

/// f·L·cos/pdf of one light sample, or 0 where it is occluded; weighted against BSDF sampling where `mis` is set
/// (Veach & Guibas 1995).
template <FeatureBits F, class Bsdf>
RL_HD inline Rgb directLight(const FrameView& frame, const Surface& s, const Frame& local, const Bsdf& bsdf, Vec3 wo,
                             Sampler& sampler, bool mis, Tally& tally) {
  Real const uLight = sampler.next1();
  DirectSample const light = sampleLight<F>(frame.scene, s, uLight, sampler.next2());
  if (light.pdf == 0) return Rgb(0.0f);
  Vec3 const wi = local.toLocal(light.wi);
  Rgb const f = bsdf.eval(wo, wi);
  if (isBlack(f)) return Rgb(0.0f);
  ++tally.shadowRays;
  if (shadowed<F>(frame.scene, s, light)) return Rgb(0.0f);
  Real const weight = mis ? powerHeuristic(light.pdf, bsdf.pdf(wo, wi)) : Real(1);
  return f * light.radiance * float(abs(wi.z) * weight / light.pdf);
}

}  // namespace ropelight::RL_TARGET
