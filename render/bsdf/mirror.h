#pragma once
// Perfect specular reflection on both sides.

#include "render/bsdf/bsdf.h"
#include "render/core/features.h"
#include "render/core/params.h"

namespace ropelight {

struct MirrorParams {
  static constexpr const char* name = "mirror";
  static constexpr const char* doc = "Perfect specular reflection on both sides.";
  static constexpr FeatureBits bit = feature::mirror;
  static constexpr bool transmits = false;
  Rgb reflectance{1.0f};

  template <class V>
  void params(V&& v) {
    v("reflectance", reflectance, ParamInfo{"fraction of the light reflected", 0, 1});
  }
};

}  // namespace ropelight

namespace ropelight::RL_TARGET {

struct Mirror : MirrorParams {
  using Params = MirrorParams;
  static constexpr std::uint32_t possibleLobes = lobe::specular;

  RL_HD std::uint32_t lobes() const { return possibleLobes; }

  RL_HD Rgb directionalAlbedo(Vec3 /*wo*/) const { return reflectance; }

  RL_HD Rgb eval(Vec3, Vec3) const { return Rgb(0.0f); }
  RL_HD Real pdf(Vec3, Vec3) const { return 0; }

  RL_HD BsdfSample sample(Vec3 wo, Real /*lobe*/, Vec2 /*u*/, Transport) const {
    BsdfSample s;
    s.wi = Vec3(-wo.x, -wo.y, wo.z);
    s.weight = reflectance;
    s.pdf = 1;
    s.lobes = lobe::specular;
    return s;
  }
};

}  // namespace ropelight::RL_TARGET
