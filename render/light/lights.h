#pragma once
// The questions that integrators ask of a scene's lights: where does a photon start, what light reaches this point,
// what does a ray bring that leaves the scene. Lights are picked in proportion to their power.

#include "render/light/aim.h"
#include "render/light/emitters.h"
#include "render/light/guide_table.h"

namespace ropelight::RL_TARGET {

/// Index of the light whose share of [0, 1) holds u; u is rescaled to [0, 1) within the share.
RL_HD inline std::uint32_t pickLight(const SceneView& scene, Real& u) {
  std::uint32_t const k = scene.lights.size > 1 ? findByGuide(scene.lightCdf, scene.lightGuide, u) : 0;
  Real const before = k > 0 ? scene.lightCdf[k - 1] : Real(0);
  u = minOf(maxOf((u - before) / scene.lights[k].pick, Real(0)), 1 - machineEpsilon);
  return k;
}

template <FeatureBits F>
RL_HD inline Emitted emitPhoton(const SceneView& scene, Real uLight, Vec2 uPoint, Vec2 uDirection, Real paths) {
  Emitted e;
  const Light& light = scene.lights[pickLight(scene, uLight)];
  visitEmitter<F>(light, [&](auto kind) { kind.emit(scene, light, EmissionSample{uLight, uPoint, uDirection}, e); });
  e.flux = light.radiance * float(scene.power / (paths * Real(mean(light.radiance))));
  return e;
}

/// A photon towards specular surfaces; flux 0 where it misses them. uTarget: picks one. Lights that are no surfaces
/// send it anywhere.
template <FeatureBits F>
RL_HD inline Emitted emitAimed(const SceneView& scene, Real uLight, Real uTarget, Vec2 uPoint, Vec2 uDirection,
                               Real paths) {
  Emitted e;
  const Light& light = scene.lights[pickLight(scene, uLight)];
  Real factor = 1;
  visitEmitter<F>(light, [&](auto kind) {
    EmissionSample const u{uLight, uPoint, uDirection};
    if constexpr (requires { kind.start(scene, light, u, e); }) {
      Vec3 const n = kind.start(scene, light, u, e);
      Aimed const aimed = aimAt(scene.targets, e.surface.p, n, uTarget, uDirection);
      e.direction = aimed.direction;
      factor = aimed.factor;
    } else {
      kind.emit(scene, light, u, e);
    }
  });
  e.flux = light.radiance * float(factor * scene.power / (paths * Real(mean(light.radiance))));
  return e;
}

template <FeatureBits F>
RL_HD inline DirectSample sampleLight(const SceneView& scene, const Surface& from, Real uLight, Vec2 u) {
  DirectSample s;
  std::uint32_t const index = pickLight(scene, uLight);
  const Light& light = scene.lights[index];
  visitEmitter<F>(light, [&](auto kind) { kind.template sampleToward<F>(scene, light, from, u, s); });
  s.pdf *= light.pick;
  if constexpr ((F & feature::environment) != 0)
    if (s.infinite) return s;
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
  visitEmitter<F>(light, [&](auto kind) { pdf = kind.pdfToward(scene, light, from, on, toward); });
  return pdf * light.pick;
}

/// What a ray brings that leaves the scene along w (unit): radiance, and the density per solid angle with which
/// sampleLight at `from` would have chosen w.
struct Beyond {
  Rgb radiance{0.0f};
  Real pdf = 0;
};

template <FeatureBits F>
RL_HD inline Beyond beyondScene(const SceneView& scene, Vec3 from, Vec3 w) {
  Beyond sum;
  if constexpr ((F & feature::environment) != 0) {
    for (std::uint32_t i = 0; i < scene.lights.size; ++i) {
      const Light& light = scene.lights[i];
      visitEmitter<F>(light, [&](auto kind) {
        Rgb const radiance = kind.beyond(scene, light, w);
        if (isBlack(radiance)) return;
        sum.radiance += radiance;
        sum.pdf += kind.pdfToward(scene, light, from, Surface{}, w) * light.pick;
      });
    }
  }
  return sum;
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
  if constexpr ((F & feature::environment) != 0)
    if (light.infinite)
      return ShadowRay{Ray{offsetRayOrigin(s.p, s.error, s.n, light.wi), light.wi, infinity}, noPrimitive, blocked};
  return ShadowRay{segment(s, light.toward, on), on.primitive, blocked};
}

/// Whether anything stands in the segment's way.
template <FeatureBits F>
RL_HD inline bool occluded(const SceneView& scene, const ShadowRay& shadow) {
  return shadow.blocked || occluded<F>(scene, shadow.ray, shadow.ignored);
}

}  // namespace ropelight::RL_TARGET
