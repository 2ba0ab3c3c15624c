#pragma once
// The list of light shapes, and the two questions that the integrators ask: where does a photon start, and what light
// reaches this point. Lights are chosen in proportion to their power.

#include "render/core/frame.h"
#include "render/core/warp.h"
#include "render/intersection/flight.h"
#include "render/light/quad_light.h"
#include "render/light/sphere_light.h"

namespace ropelight::RL_TARGET {

/// Calls visit(Kind{}, shape) for the shape of a light, by the same numbering as primitives.
template <FeatureBits F, class Visit>
RL_HD inline void visitLight(const SceneView& scene, const Light& light, Visit&& visit) {
  if constexpr ((F & feature::quads) != 0)
    if (light.primitive < scene.quads.size) return visit(QuadLight{}, scene.quads[light.primitive]);
  if constexpr ((F & feature::spheres) != 0) visit(SphereLight{}, scene.spheres[light.primitive - scene.quads.size]);
}

/// Index of the light whose share of [0, 1) holds u; u is rescaled to [0, 1) within the share.
RL_HD inline std::uint32_t pickLight(const SceneView& scene, Real& u) {
  std::uint32_t low = 0, high = scene.lights.size - 1;
  while (low < high) {
    std::uint32_t const middle = (low + high) / 2;
    if (u < scene.lightCdf[middle])
      high = middle;
    else
      low = middle + 1;
  }
  Real const before = low > 0 ? scene.lightCdf[low - 1] : Real(0);
  u = minOf(maxOf((u - before) / scene.lights[low].pick, Real(0)), 1 - machineEpsilon);
  return low;
}

/// The start of a photon path. flux: watts of one path out of `paths`, the same for every light before colour.
struct Emitted {
  Surface surface;
  Vec3 direction{0};
  Rgb flux{0.0f};
};

template <FeatureBits F>
RL_HD inline Emitted emitPhoton(const SceneView& scene, Real uLight, Vec2 uPoint, Vec2 uDirection, Real paths) {
  Emitted e;
  const Light& light = scene.lights[pickLight(scene, uLight)];
  visitLight<F>(scene, light, [&](auto kind, const auto& shape) { kind.samplePoint(shape, uPoint, e.surface); });
  e.surface.primitive = light.primitive;
  bool const inward =
      light.side == std::uint32_t(Side::in) || (light.side == std::uint32_t(Side::both) && uLight < 0.5f);
  Vec3 const n = inward ? -e.surface.n : e.surface.n;
  e.direction = normalize(Frame(n).toWorld(cosineHemisphere(uDirection)));
  e.flux = light.radiance * float(scene.power / (paths * Real(mean(light.radiance))));
  return e;
}

/// One sample of the light that reaches a point: towards it, at what density per solid angle, how much if unoccluded.
struct DirectSample {
  Surface surface;  ///< on the light
  Vec3 toward{0};   ///< from the point to it, scene units
  Vec3 wi{0};       ///< the same with unit length
  Real pdf = 0;     ///< 0: nothing to be had here
  Rgb radiance{0.0f};
};

template <FeatureBits F>
RL_HD inline DirectSample sampleLight(const SceneView& scene, const Surface& from, Real uLight, Vec2 u) {
  DirectSample s;
  std::uint32_t const index = pickLight(scene, uLight);
  const Light& light = scene.lights[index];
  Receiver const receiver{from.p, samePlace<F>(scene, from.primitive, light.primitive)};
  visitLight<F>(scene, light, [&](auto kind, const auto& shape) {
    s.pdf = kind.sampleToward(shape, light.area, receiver, u, s.surface, s.toward) * light.pick;
  });
  s.surface.primitive = light.primitive;
  s.surface.light = std::int32_t(index);
  Real const distance2 = lengthSquared(s.toward);
  if (!(distance2 > 0) || !(s.pdf > 0)) {
    s.pdf = 0;
    return s;
  }
  s.wi = s.toward * (1 / sqrt(distance2));
  s.radiance = emitted(scene, s.surface, -s.wi);
  if (isBlack(s.radiance)) s.pdf = 0;
  return s;
}

/// Density per solid angle with which sampleLight at `from` would have chosen the emitting point `on`, seen along the
/// unit direction w.
template <FeatureBits F>
RL_HD inline Real lightPdf(const SceneView& scene, Vec3 from, const Surface& on, Vec3 w) {
  const Light& light = scene.lights[std::uint32_t(on.light)];
  Vec3 const toward = w * sqrt(lengthSquared(on.p - from));
  Real pdf = 0;
  visitLight<F>(scene, light,
                [&](auto kind, const auto& shape) { pdf = kind.pdfToward(shape, light.area, from, on, toward); });
  return pdf * light.pick;
}

/// The segment from a surface point to the one at `toward` from it, kept clear of both surfaces; directions are t in
/// (0, 1].
RL_HD inline Ray segment(const Surface& a, Vec3 toward, const Surface& b) {
  Vec3 const from = offsetSegmentEnd(a.p, a.error, a.n, toward);
  Vec3 const to = offsetSegmentEnd(a.p + toward, b.error, b.n, -toward);
  return Ray{from, to - from, Real(1)};
}

/// The segment from a surface point to a sampled point of a light. blocked: something at the same place as one of its
/// ends hides the other.
struct ShadowRay {
  Ray ray;
  std::uint32_t ignored = noPrimitive;
  bool blocked = false;
};

template <FeatureBits F>
RL_HD inline ShadowRay shadowRay(const SceneView& scene, const Surface& s, const DirectSample& light) {
  Surface on = light.surface;
  bool blocked = false;
  if constexpr ((F & feature::coincident) != 0) {
    blocked = stack::before<F>(scene, s, light.toward).found() || stack::before<F>(scene, on, -light.toward).found();
    stack::widen(on, stack::layerOf(scene, on.primitive));
  }
  return ShadowRay{segment(s, light.toward, on), on.primitive, blocked};
}

/// Whether anything stands in the segment's way.
template <FeatureBits F>
RL_HD inline bool occluded(const SceneView& scene, const ShadowRay& shadow) {
  return shadow.blocked || occluded<F>(scene, shadow.ray, shadow.ignored);
}

}  // namespace ropelight::RL_TARGET
