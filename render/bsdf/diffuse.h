#pragma once
// Lambertian reflection on both sides of a surface: f = albedo/π where wo and wi share a side.

#include "render/bsdf/bsdf.h"
#include "render/core/features.h"
#include "render/core/params.h"
#include "render/core/warp.h"

namespace ropelight {

struct DiffuseParams {
  static constexpr const char* name = "diffuse";
  static constexpr const char* doc = "Lambertian reflection on both sides.";
  static constexpr FeatureBits bit = feature::diffuse;
  static constexpr bool transmits = false;
  Rgb albedo{0.8f};

  template <class V>
  void params(V&& v) {
    v("albedo", albedo, ParamInfo{"fraction of the light reflected", 0, 1});
  }
};

}  // namespace ropelight

namespace ropelight::RL_TARGET {

struct Diffuse : DiffuseParams {
  using Params = DiffuseParams;
  static constexpr std::uint32_t possibleLobes = lobe::diffuse;

  RL_HD std::uint32_t lobes() const { return possibleLobes; }

  RL_HD Rgb directionalAlbedo(Vec3 /*wo*/) const { return albedo; }

  RL_HD Rgb eval(Vec3 wo, Vec3 wi) const { return wo.z * wi.z > 0 ? albedo * float(invPi) : Rgb(0.0f); }

  RL_HD Real pdf(Vec3 wo, Vec3 wi) const { return wo.z * wi.z > 0 ? cosineHemispherePdf(abs(wi.z)) : Real(0); }

  RL_HD BsdfSample sample(Vec3 wo, Real /*lobe*/, Vec2 u, Transport) const {
    BsdfSample s;
    s.wi = cosineHemisphere(u);
    s.pdf = cosineHemispherePdf(s.wi.z);
    if (wo.z < 0) s.wi.z = -s.wi.z;
    s.weight = albedo;
    s.lobes = lobe::diffuse;
    return s;
  }
};

}  // namespace ropelight::RL_TARGET
