#pragma once
// What the families measure against, in double precision.

#include <cmath>
#include <numbers>

namespace ropelight {

/// Fresnel reflectance for unpolarised light; cosine of the angle of incidence, index of the far side over the near
/// one (Born & Wolf, Principles of Optics, §1.5.2).
inline double fresnelReflectance(double cosine, double index) {
  double const sine2 = (1 - cosine * cosine) / (index * index);
  if (sine2 >= 1) return 1;
  double const inside = std::sqrt(1 - sine2);
  double const parallel = (index * cosine - inside) / (index * cosine + inside);
  double const perpendicular = (cosine - index * inside) / (cosine + index * inside);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

/// Share of the light that passes a plane-parallel plate without absorption, all internal reflections included:
/// (1 − R)/(1 + (m − 1)R) of m such interfaces.
inline double plateTransmittance(double cosine, double index, int interfaces = 2) {
  double const r = fresnelReflectance(cosine, index);
  return (1 - r) / (1 + (interfaces - 1) * r);
}

/// ∫₀¹ f(x) dx by the midpoint rule.
template <class F>
double integrate(F&& f, int steps = 20000) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += f((i + 0.5) / steps);
  return sum / steps;
}

/// The same of light that arrives with equal radiance from all sides: 2∫ T(cos) cos dcos. In x = cos² the integrand is
/// smooth but near 0, where it vanishes.
inline double diffusePlateTransmittance(double index, int interfaces = 2) {
  return integrate([&](double x) { return plateTransmittance(std::sqrt(x), index, interfaces); });
}

}  // namespace ropelight
