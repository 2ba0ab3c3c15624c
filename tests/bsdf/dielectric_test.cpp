// The optics of smooth dielectrics, against Snell's law and Fresnel's equations in other forms.

#include "render/bsdf/dielectric.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/core/numeric.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

Vec3 direction(double cosine, double turn) {
  double const r = std::sqrt(1 - cosine * cosine);
  return Vec3(Vec3d(r * std::cos(2 * M_PI * turn), r * std::sin(2 * M_PI * turn), cosine));
}

Dielectric glass(float ior) {
  Dielectric d;
  d.ior = ior;
  return d;
}

struct Reference {
  double reflectance, cosT;
};

/// From Snell's law by angles and the sine and tangent forms of Fresnel's equations; 0 < angle < π/2, no total
/// reflection.
Reference fresnelByAngles(double angle, double eta) {
  double const t = std::asin(std::sin(angle) / eta);
  double const s = std::sin(angle - t) / std::sin(angle + t), p = std::tan(angle - t) / std::tan(angle + t);
  return {(s * s + p * p) / 2, std::cos(t)};
}

double fresnel(double cosI, double eta) {
  Real cosT;
  return double(fresnelDielectric(Real(cosI), Real(eta), cosT));
}

bool finite(const BsdfSample& s) {
  return isFinite(s.wi) && isFinite(Vec3(s.weight)) && isFinite(s.pdf) && isFinite(s.radianceScale);
}

}  // namespace

TEST_CASE("interfaces of any index are finite at every angle") {
  float const tiny = std::numeric_limits<float>::denorm_min();
  for (float ior : {0.1f, 0.9999999f, 1.0f, 1.0000001f, 1.5f, 10.0f})
    for (float z : {0.0f, -0.0f, tiny, -tiny, 1e-4f, -1e-4f, 1.0f, -1.0f})
      for (float lobe : {0.0f, std::nextafter(1.0f, 0.0f)}) {
        CAPTURE(ior);
        CAPTURE(z);
        BsdfSample const s = glass(ior).sample(Vec3(std::sqrt(1 - z * z), 0, z), lobe, Vec2(0), Transport::radiance);
        CHECK(finite(s));
        CHECK(s.pdf > 0);
      }
}

TEST_CASE("Fresnel reflectance has the textbook values") {
  auto const degrees = [](double a) { return std::cos(a * M_PI / 180); };
  for (double n : {1.33, 1.5, 2.4, 1 / 1.5})  // normal incidence
    CHECK(fresnel(1, n) == doctest::Approx((n - 1) * (n - 1) / ((n + 1) * (n + 1))).epsilon(1e-5));
  CHECK(fresnel(degrees(45), 1.5) == doctest::Approx(0.050240).epsilon(1e-6));
  CHECK(fresnel(degrees(60), 1.5) == doctest::Approx(0.089186).epsilon(1e-6));
  CHECK(fresnel(0, 1.5) == 1);
  CHECK(fresnel(1e-7, 1.5) == doctest::Approx(1).epsilon(1e-5));
  for (double c : {1.0, 0.5, 0.01}) CHECK(fresnel(c, 1) == doctest::Approx(0).epsilon(1e-6));
}

TEST_CASE("Fresnel reflectance agrees with the sine and tangent forms") {
  double worst = 0;
  for (double eta : {1.1, 1.5, 2.4, 5.0, 1 / 1.1, 1 / 1.5})
    for (double angle = 0.02; angle < 1.55; angle += 0.01) {
      if (std::sin(angle) / eta > 0.999) continue;
      Real cosT;
      double const r = double(fresnelDielectric(Real(std::cos(angle)), Real(eta), cosT));
      Reference const expected = fresnelByAngles(angle, eta);
      worst = std::max({worst, std::abs(r - expected.reflectance), std::abs(double(cosT) - expected.cosT)});
    }
  CHECK(worst < 2e-5);
}

TEST_CASE("at Brewster's angle only half of the perpendicular light is reflected") {
  for (double n : {1.33, 1.5, 2.4}) {
    double const brewster = std::atan(n), s = std::cos(2 * brewster);  // r_s = (1 − n²)/(1 + n²)
    CHECK(fresnel(std::cos(brewster), n) == doctest::Approx(s * s / 2).epsilon(1e-5));
  }
}

TEST_CASE("beyond the critical angle everything is reflected, from the dense side alone") {
  double const critical = std::sqrt(1 - 1 / (1.5 * 1.5));  // its cosine
  TestRandom random(4);
  int refracted = 0;
  for (int i = 0; i < 1000; ++i) {
    double const cosine = random.between(0, critical - 1e-5);
    Vec3 const wo = direction(-cosine, random.unit());
    BsdfSample const s = glass(1.5f).sample(wo, random.vec2().x, Vec2(0), Transport::radiance);
    refracted += s.wi.z > 0 || s.pdf != 1 || s.weight != Rgb(1.0f) || s.radianceScale != 1;
  }
  CHECK(refracted == 0);
  float const last = std::nextafter(1.0f, 0.0f);
  CHECK(glass(1.5f).sample(direction(-critical - 1e-4, 0), last, Vec2(0), Transport::flux).wi.z > 0);
  CHECK(glass(1.5f).sample(direction(0.01, 0), last, Vec2(0), Transport::flux).wi.z < 0);
}

TEST_CASE("refraction obeys Snell's law both ways and is reversible") {
  TestRandom random(5);
  float const last = std::nextafter(1.0f, 0.0f);
  double worst = 0;
  for (double ior : {1.1, 1.5, 2.4, 0.7})
    for (int i = 0; i < 1000; ++i) {
      Vec3 const wo = direction(random.between(-1, 1), random.unit());
      BsdfSample const s = glass(Real(ior)).sample(wo, last, Vec2(0), Transport::radiance);
      if ((s.wi.z > 0) == (wo.z > 0)) continue;  // total reflection
      double const etaI = wo.z > 0 ? 1 : ior, etaT = wo.z > 0 ? ior : 1;
      worst = std::max(worst, std::abs(etaI * wo.x + etaT * s.wi.x));
      worst = std::max(worst, std::abs(etaI * wo.y + etaT * s.wi.y));
      // Near grazing the way back is ill-conditioned: an error of ε in the sine is one of ε/cos in the cosine.
      BsdfSample const back = glass(Real(ior)).sample(s.wi, last, Vec2(0), Transport::radiance);
      if (std::abs(wo.z) > 0.05) worst = std::max(worst, 0.05 * double(glm::length(back.wi - wo)));
    }
  CHECK(worst < 1e-6);
}

TEST_CASE("refraction scales radiance and not flux, and a round trip scales nothing") {
  float const last = std::nextafter(1.0f, 0.0f);
  for (double ior : {1.5, 2.4, 0.7}) {
    CAPTURE(ior);
    Vec3 const wo = direction(0.9, 0.2);
    BsdfSample const in = glass(Real(ior)).sample(wo, last, Vec2(0), Transport::radiance);
    BsdfSample const out = glass(Real(ior)).sample(in.wi, last, Vec2(0), Transport::radiance);
    CHECK(in.weight.x == doctest::Approx(1 / (ior * ior)));  // (η_i/η_t)², wo outside
    CHECK(out.weight.x == doctest::Approx(ior * ior));
    CHECK(in.weight.x * out.weight.x == doctest::Approx(1));
    CHECK(in.radianceScale == doctest::Approx(in.weight.x));
    CHECK(glass(Real(ior)).sample(wo, last, Vec2(0), Transport::flux).weight == Rgb(1.0f));
    CHECK(glass(Real(ior)).sample(in.wi, last, Vec2(0), Transport::flux).weight == Rgb(1.0f));
  }
}

TEST_CASE("a dielectric picks its lobes by their reflectance and tints each") {
  Dielectric d = glass(1.5f);
  d.reflectance = Rgb(1, 0, 0);
  d.transmittance = Rgb(0, 1, 0);
  Vec3 const wo = direction(0.3, 0.6);
  constexpr int n = 10000;
  int reflected = 0;
  for (int i = 0; i < n; ++i) {
    BsdfSample const s = d.sample(wo, Real(i + 0.5) / n, Vec2(0), Transport::flux);
    bool const up = s.wi.z > 0;
    reflected += up;
    if (s.weight != (up ? Rgb(1, 0, 0) : Rgb(0, 1, 0))) FAIL("the wrong tint");
  }
  CHECK(double(reflected) / n == doctest::Approx(fresnelByAngles(std::acos(0.3), 1.5).reflectance).epsilon(0.01));
}
