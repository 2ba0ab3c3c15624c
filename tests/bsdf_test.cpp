// What every BSDF must obey, and the optics of the specular ones.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/bsdf/bsdfs.h"
#include "tests/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

/// Sets every colour of a BSDF.
struct SetColours {
  Rgb colour;
  void operator()(const char*, Rgb& value, const ParamInfo&) const { value = colour; }
  void operator()(const char*, float&, const ParamInfo&) const {}
};

template <class T>
T tinted(Rgb colour) {
  T bsdf{};
  bsdf.params(SetColours{colour});
  return bsdf;
}

/// Calls visit(bsdf) for one BSDF of every kind.
template <class Visit>
void forEveryBsdf(Rgb colour, Visit&& visit) {
  Bsdfs::forEach([&](auto type, int) {
    using T = typename decltype(type)::type;
    CAPTURE(T::name);
    visit(tinted<T>(colour));
  });
}

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

TEST_CASE("reflection is reciprocal") {
  TestRandom random(1);
  forEveryBsdf(Rgb(0.2f, 0.5f, 0.9f), [&](const auto& bsdf) {
    int asymmetric = 0;
    for (int i = 0; i < 2000; ++i) {
      Vec3 const a(random.direction()), b(random.direction());
      asymmetric += bsdf.eval(a, b) != bsdf.eval(b, a);
    }
    CHECK(asymmetric == 0);
  });
}

TEST_CASE("no BSDF reflects more flux than arrives") {
  constexpr int steps = 128;
  forEveryBsdf(Rgb(1.0f), [&](const auto& bsdf) {
    using T = std::decay_t<decltype(bsdf)>;
    for (double cosine : {1.0, 0.7, 0.1, 0.001, -0.001, -0.4, -1.0}) {
      CAPTURE(cosine);
      Vec3 const wo = direction(cosine, 0.3);
      double sum = 0;
      if constexpr (T::specular) {
        for (int i = 0; i < steps; ++i)
          sum += bsdf.sample(wo, Real(i + 0.5) / steps, Vec2(0.5f), Transport::flux).weight.y / steps;
      } else {
        for (int i = 0; i < 2 * steps; ++i)
          for (int j = 0; j < steps; ++j) {
            double const z = (i + 0.5) / steps - 1;
            sum += bsdf.eval(wo, direction(z, (j + 0.5) / steps)).y * std::abs(z) * 2 * M_PI / (steps * steps);
          }
      }
      CHECK(sum <= 1 + 1e-5);
      CHECK(sum > 0.5);
    }
  });
}

TEST_CASE("a diffuse surface's albedo is the integral of f cos") {
  Rgb const albedo(0.2f, 0.5f, 0.9f);
  Diffuse const diffuse = tinted<Diffuse>(albedo);
  constexpr int steps = 400;
  for (Vec3 wo : {direction(0.8, 0.1), direction(-0.3, 0.9)}) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 2 * steps; ++i) {
      double const z = (i + 0.5) / steps - 1;
      sum += glm::dvec3(diffuse.eval(wo, direction(z, 0.2))) * std::abs(z) * 2.0 * M_PI / double(steps);
    }
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(double(albedo[c])).epsilon(1e-5));
  }
}

TEST_CASE("the weight of a sample is f cos over its density") {
  TestRandom random(2);
  forEveryBsdf(Rgb(0.2f, 0.5f, 0.9f), [&](const auto& bsdf) {
    if constexpr (!std::decay_t<decltype(bsdf)>::specular) {
      double worst = 0;
      for (int i = 0; i < 5000; ++i) {
        Vec3 const wo(random.direction());
        BsdfSample const s = bsdf.sample(wo, random.vec2().x, random.vec2(), Transport::radiance);
        Rgb const weight = bsdf.eval(wo, s.wi) * float(std::abs(s.wi.z)) / float(s.pdf);
        worst = std::max(worst, double(glm::length(weight - s.weight)));
        worst = std::max(worst, std::abs(double(bsdf.pdf(wo, s.wi)) / double(s.pdf) - 1));
      }
      CHECK(worst < 1e-5);
    }
  });
}

TEST_CASE("specular BSDFs have no density and a unit direction on every lobe") {
  TestRandom random(3);
  forEveryBsdf(Rgb(1.0f), [&](const auto& bsdf) {
    if constexpr (std::decay_t<decltype(bsdf)>::specular) {
      double worst = 0;
      int dense = 0, improbable = 0;
      for (int i = 0; i < 5000; ++i) {
        Vec3 const wo(random.direction()), other(random.direction());
        BsdfSample const s = bsdf.sample(wo, random.vec2().x, random.vec2(), Transport::radiance);
        worst = std::max(worst, std::abs(double(lengthSquared(s.wi)) - 1));
        dense += !isBlack(bsdf.eval(wo, other)) || bsdf.pdf(wo, other) != 0;
        improbable += !(s.pdf > 0 && s.pdf <= 1);
      }
      CHECK(worst < 2e-6);
      CHECK(dense == 0);
      CHECK(improbable == 0);
    }
  });
}

TEST_CASE("no direction makes a BSDF lose its numbers") {
  float const tiny = std::numeric_limits<float>::denorm_min(), last = std::nextafter(1.0f, 0.0f);
  std::vector<Vec3> directions{{0, 0, 1}, {0, 0, -1}, {0, 0, 1.0000001f}, {1, 0, 0}, {-0.6f, 0.8f, -0.0f}};
  for (float z : {tiny, 1e-30f, 1e-10f, 1e-4f})
    for (float sign : {1.0f, -1.0f}) directions.push_back(Vec3(0, 1, sign * z));
  forEveryBsdf(Rgb(0.5f), [&](const auto& bsdf) {
    for (Vec3 wo : directions)
      for (float lobe : {0.0f, 0.5f, last})
        for (Transport transport : {Transport::radiance, Transport::flux}) {
          CAPTURE(wo.z);
          BsdfSample const s = bsdf.sample(wo, lobe, Vec2(0, last), transport);
          CHECK(finite(s));
          CHECK(s.pdf > 0);
          CHECK((isFinite(Vec3(bsdf.eval(wo, s.wi))) && isFinite(bsdf.pdf(wo, s.wi))));
        }
  });
}

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

TEST_CASE("a mirror reflects about the normal on both sides") {
  Mirror const mirror = tinted<Mirror>(Rgb(0.3f));
  BsdfSample const s = mirror.sample(Vec3(0.6f, 0, -0.8f), 0.5f, Vec2(0), Transport::radiance);
  CHECK(s.wi == Vec3(-0.6f, 0, -0.8f));
  CHECK(s.weight == Rgb(0.3f));
  CHECK(s.radianceScale == 1);
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
