// What every BSDF must obey.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/bsdf/bsdfs.h"
#include "tests/support/test_random.h"

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
      if constexpr ((T::possibleLobes & lobe::gathered) == 0) {
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
    if constexpr ((std::decay_t<decltype(bsdf)>::possibleLobes & lobe::gathered) != 0) {
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
    if constexpr ((std::decay_t<decltype(bsdf)>::possibleLobes & lobe::gathered) == 0) {
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

TEST_CASE("a mirror reflects about the normal on both sides") {
  Mirror const mirror = tinted<Mirror>(Rgb(0.3f));
  BsdfSample const s = mirror.sample(Vec3(0.6f, 0, -0.8f), 0.5f, Vec2(0), Transport::radiance);
  CHECK(s.wi == Vec3(-0.6f, 0, -0.8f));
  CHECK(s.weight == Rgb(0.3f));
  CHECK(s.radianceScale == 1);
}
