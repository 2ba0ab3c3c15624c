#pragma once
// A smooth interface between two dielectrics: exact Fresnel reflectance for unpolarised light, total internal
// reflection.

#include "render/bsdf/bsdf.h"
#include "render/core/features.h"
#include "render/core/params.h"

namespace ropelight {

struct DielectricParams {
  static constexpr const char* name = "dielectric";
  static constexpr const char* doc = "Smooth glass or water: Fresnel reflection and refraction.";
  static constexpr FeatureBits bit = feature::dielectric;
  static constexpr bool transmits = true;
  float ior = 1.5f;  ///< inside (the side that the normal points away from) over outside
  Rgb reflectance{1.0f};
  Rgb transmittance{1.0f};

  template <class V>
  void params(V&& v) {
    v("ior", ior, ParamInfo{"index of refraction, inside over outside", 0.1, 10});
    v("reflectance", reflectance, ParamInfo{"tint of the reflected light", 0, 1});
    v("transmittance", transmittance, ParamInfo{"tint of the refracted light", 0, 1});
  }
};

}  // namespace ropelight

namespace ropelight::RL_TARGET {

/// Fresnel reflectance of a smooth interface for unpolarised light (Born & Wolf, Principles of Optics, §1.5.2).
/// cosI ≥ 0 on the side of incidence; eta = η_t/η_i. Writes cos θ_t ≥ 0, or 0 under total internal reflection.
RL_HD inline Real fresnelDielectric(Real cosI, Real eta, Real& cosT) {
  Real sin2T = (1 - cosI * cosI) / (eta * eta);
  if (faulty(Fault::totalReflection)) sin2T = minOf(sin2T, Real(0.999));
  if (sin2T >= 1) {
    cosT = 0;
    return 1;
  }
  cosT = sqrt(1 - sin2T);
  if (faulty(Fault::reflectance)) {
    Real const r = (1 - eta) / (1 + eta), c = 1 - (eta < 1 ? cosT : cosI);
    return r * r + (1 - r * r) * c * c * c * c * c;
  }
  Real const parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
  Real const perpendicular = (cosI - eta * cosT) / (cosI + eta * cosT);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

struct Dielectric : DielectricParams {
  using Params = DielectricParams;
  static constexpr std::uint32_t possibleLobes = lobe::specular | lobe::transmission;

  RL_HD std::uint32_t lobes() const { return possibleLobes; }

  RL_HD Rgb directionalAlbedo(Vec3 wo) const {
    Real cosT;
    float const reflected = float(fresnelDielectric(abs(wo.z), wo.z > 0 ? Real(ior) : 1 / Real(ior), cosT));
    return reflectance * reflected + transmittance * (1 - reflected);
  }

  RL_HD Rgb eval(Vec3, Vec3) const { return Rgb(0.0f); }
  RL_HD Real pdf(Vec3, Vec3) const { return 0; }

  /// Picks reflection with probability F. Refraction scales radiance by (η_i/η_t)², where wo lies in medium i, and
  /// leaves flux alone (Veach 1997, §5.2).
  RL_HD BsdfSample sample(Vec3 wo, Real lobe, Vec2 /*u*/, Transport transport) const {
    BsdfSample s;
    Real const eta = wo.z > 0 ? Real(ior) : 1 / Real(ior);
    Real cosT;
    Real const reflected = fresnelDielectric(abs(wo.z), eta, cosT);
    if (lobe < reflected) {
      s.wi = Vec3(-wo.x, -wo.y, wo.z);
      s.weight = reflectance;
      s.pdf = reflected;
      s.lobes = lobe::specular;
      return s;
    }
    s.wi = Vec3(-wo.x / eta, -wo.y / eta, wo.z > 0 ? -cosT : cosT);
    s.weight = transmittance;
    s.pdf = 1 - reflected;
    s.lobes = lobe::specular | lobe::transmission;
    s.radianceScale = 1 / (eta * eta);
    if (transport == Transport::radiance) s.weight *= float(s.radianceScale);
    return s;
  }
};

}  // namespace ropelight::RL_TARGET
