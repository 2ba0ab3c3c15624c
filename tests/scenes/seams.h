#pragma once
// A glossy BSDF and a light without a place, for tests of what the core is ready for. The including unit has a target
// of its own, whose lists name them.

#include "render/bsdf/bsdf.h"
#include "render/core/features.h"
#include "render/core/frame.h"
#include "render/core/warp.h"
#include "render/intersection/surface.h"
#include "render/light/emitter.h"

namespace ropelight::RL_TARGET {

/// The normalised Phong lobe around the mirror direction (Lafortune & Willems 1994): f = ρ (n + 2)/(2π) cosⁿ α.
struct Phong {
  static constexpr const char* name = "phong";
  static constexpr FeatureBits bit = feature::glossy;
  static constexpr std::uint32_t possibleLobes = lobe::glossy;

  Rgb reflectance{0.9f};
  float exponent = 20;

  RL_HD std::uint32_t lobes() const { return possibleLobes; }
  RL_HD Rgb directionalAlbedo(Vec3) const { return reflectance; }

  RL_HD Rgb eval(Vec3 wo, Vec3 wi) const {
    if (wo.z * wi.z <= 0) return Rgb(0.0f);
    return reflectance * float((exponent + 2) * (invPi / 2) * lobeAt(wo, wi));
  }
  RL_HD Real pdf(Vec3 wo, Vec3 wi) const {
    return wo.z * wi.z > 0 ? (exponent + 1) * (invPi / 2) * lobeAt(wo, wi) : Real(0);
  }
  RL_HD BsdfSample sample(Vec3 wo, Real /*lobe*/, Vec2 u, Transport) const {
    BsdfSample s;
    Real const cosine = std::pow(u.x, 1 / (Real(exponent) + 1)), sine = std::sqrt(maxOf(1 - cosine * cosine, Real(0)));
    Real const phi = 2 * pi * u.y;
    s.wi = Frame(Vec3(-wo.x, -wo.y, wo.z)).toWorld(Vec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
    s.pdf = pdf(wo, s.wi);
    s.lobes = lobe::glossy;
    if (s.pdf > 0) s.weight = eval(wo, s.wi) * float(abs(s.wi.z) / s.pdf);
    return s;
  }

 private:
  RL_HD Real lobeAt(Vec3 wo, Vec3 wi) const {
    Real const cosine = dot(Vec3(-wo.x, -wo.y, wo.z), wi);
    return cosine > 0 ? std::pow(cosine, Real(exponent)) : Real(0);
  }
};

/// The same radiance from everywhere, sampled uniformly over the sphere.
struct ConstantSky {
  static constexpr FeatureBits bit = feature::environment;

  RL_HD static void emit(const SceneView&, const Light&, const EmissionSample&, Emitted&) {}

  template <FeatureBits F>
  RL_HD static void sampleToward(const SceneView&, const Light& light, const Surface&, Vec2 u, DirectSample& s) {
    s.wi = uniformSphere(u);
    s.infinite = true;
    s.pdf = invPi / 4;
    s.radiance = light.radiance;
  }

  RL_HD static Real pdfToward(const SceneView&, const Light&, Vec3, const Surface&, Vec3) { return invPi / 4; }
  RL_HD static Rgb beyond(const SceneView&, const Light& light, Vec3) { return light.radiance; }
};

/// Where uv says that the point is, on the quad or the sphere of the test's scene.
inline Vec3 pointAt(const Surface& s) {
  if (s.primitive == 0) return Vec3(-1, -1, 0.5f) + s.uv.x * Vec3(2, 0, 0) + s.uv.y * Vec3(0, 2, 0.5f);
  Real const turn = 2 * pi * s.uv.x, up = pi * s.uv.y;
  return Vec3(0, 0, -3) + Vec3(std::sin(up) * std::cos(turn), std::sin(up) * std::sin(turn), -std::cos(up));
}

}  // namespace ropelight::RL_TARGET
