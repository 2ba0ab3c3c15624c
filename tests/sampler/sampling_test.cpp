// Warps and BSDF samples against their densities.

#include <doctest/doctest.h>

#include "render/bsdf/bsdfs.h"
#include "render/core/frame.h"
#include "tests/support/chi_square.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr int samples = 200000;
constexpr int tests = 32;  // χ² tests in this file, at most

/// Share of a full turn, in [0, 1).
double turn(Vec3d v) {
  double const a = std::atan2(v.y, v.x) / (2 * M_PI);
  return a < 0 ? a + 1 : a;
}

/// 1 − cos of the angle to +z, without cancellation near it.
double height(Vec3d v) { return v.z > 0 ? (v.x * v.x + v.y * v.y) / (1 + v.z) : 1 - v.z; }

/// Directions within 1 − cos θ ≤ `range` of +z, in bins of equal solid angle. density: per solid angle, of a direction.
template <class Warp, class Density>
void checkDirections(double range, Warp&& warp, Density&& density) {
  TestRandom random(7);
  Histogram2 histogram(16, 12);
  bool unit = true;
  for (int i = 0; i < samples; ++i) {
    Vec3d const v(warp(random.vec2()));
    unit = unit && std::abs(glm::dot(v, v) - 1) < 1e-6 && height(v) <= range * (1 + 1e-5);
    histogram.add(turn(v), height(v) / range);
  }
  std::vector<double> const expected = histogram.expected(8, [&](double phi, double h) {
    double const z = 1 - range * h, r = std::sqrt(range * h * (1 + z)), a = 2 * M_PI * phi;
    return double(density(Vec3(Vec3d(r * std::cos(a), r * std::sin(a), z)))) * 2 * M_PI * range;
  });
  CHECK(unit);
  CHECK(sum(expected) == doctest::Approx(samples).epsilon(1e-3));
  CHECK(chiSquareP(histogram.counts, expected) > significance(tests));
}

}  // namespace

TEST_CASE("the incomplete gamma function agrees with its closed forms") {
  for (double x : {0.01, 0.3, 1.0, 2.5, 7.0, 30.0}) {
    CHECK(upperGamma(1, x) == doctest::Approx(std::exp(-x)).epsilon(1e-12));
    CHECK(upperGamma(0.5, x) == doctest::Approx(std::erfc(std::sqrt(x))).epsilon(1e-10));
    CHECK(upperGamma(3, x) == doctest::Approx(std::exp(-x) * (1 + x + x * x / 2)).epsilon(1e-12));
  }
  CHECK(upperGamma(100, 0) == 1);
  CHECK(upperGamma(500, 500) == doctest::Approx(0.494).epsilon(0.001));  // ½ − 1/(3√(2π a)) to first order
}

TEST_CASE("the chi-square test rejects a wrong density") {
  TestRandom random(1);
  Histogram2 histogram(16, 12);
  for (int i = 0; i < samples; ++i) histogram.add(random.unit(), random.unit());
  CHECK(histogram.uniformP() > significance(tests));
  CHECK(chiSquareP(histogram.counts, histogram.expected(8, [](double x, double) { return 0.95 + 0.1 * x; })) < 1e-6);
  CHECK(chiSquareP({1000, 1000, 30}, {1000, 1000, 0}) < 1e-6);
}

TEST_CASE("the concentric disc is uniform") {
  TestRandom random(3);
  Histogram2 histogram(16, 12);
  bool inside = true;
  for (int i = 0; i < samples; ++i) {
    Vec2 const d = concentricDisc(random.vec2());
    double const r2 = double(d.x) * d.x + double(d.y) * d.y;
    inside = inside && r2 <= 1 + 1e-6;
    histogram.add(turn(Vec3d(d.x, d.y, 0)), r2);
  }
  CHECK(inside);
  CHECK(histogram.uniformP() > significance(tests));
}

TEST_CASE("the concentric disc keeps neighbours together and maps the square's rim to the circle") {
  double const step = 1.0 / 64;
  bool near = true, rim = true;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 63; ++j) {
      Vec2 const a = concentricDisc(Vec2(i * step, j * step)), b = concentricDisc(Vec2(i * step, (j + 1) * step));
      near = near && glm::length(Vec2(a.x - b.x, a.y - b.y)) < 3 * step;
      if (j == 0) rim = rim && std::abs(glm::length(a) - 1) < 1e-6f;
    }
  CHECK(near);
  CHECK(rim);
  CHECK(concentricDisc(Vec2(0.5f, 0.5f)) == Vec2(0, 0));
}

TEST_CASE("cosine-weighted directions follow their density") {
  checkDirections(1, cosineHemisphere, [](Vec3 w) { return cosineHemispherePdf(w.z); });
}

TEST_CASE("a cosine-weighted direction never lies in the surface") {
  float const last = std::nextafter(1.0f, 0.0f);
  for (float x : {0.0f, 0.25f, 0.5f, last})
    for (float y : {0.0f, 0.25f, 0.5f, last}) {
      Vec3 const w = cosineHemisphere(Vec2(x, y));
      CHECK(w.z > 0);
      CHECK(std::abs(lengthSquared(w) - 1) < 1e-6f);
    }
}

TEST_CASE("uniform directions follow their density") {
  checkDirections(2, uniformSphere, [](Vec3) { return 1 / (4 * M_PI); });
}

TEST_CASE("directions in a cone follow their density, from a hair's breadth to the whole sphere") {
  for (double range : {1e-12, 1e-6, 0.01, 0.3, 1.0, 1.9}) {
    CAPTURE(range);
    checkDirections(
        range, [&](Vec2 u) { return uniformCone(u, Real(range)); }, [&](Vec3) { return uniformConePdf(Real(range)); });
  }
}

TEST_CASE("frames are orthonormal and keep their normal, whatever it is") {
  TestRandom random(5);
  double worst = 0;
  std::vector<Vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-20f, 0, -1}, {0, 1e-4f, -1}};
  for (int i = 0; i < 10000; ++i) normals.push_back(Vec3(random.direction()));
  for (Vec3 n : normals) {
    n = glm::normalize(n);
    Frame const f(n);
    Mat3d const m{Vec3d(f.s), Vec3d(f.t), Vec3d(f.n)};
    Mat3d const gram = glm::transpose(m) * m;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) worst = std::max(worst, std::abs(gram[c][r] - (c == r)));
    worst = std::max(worst, std::abs(glm::determinant(m) - 1));
    Vec3 const w(random.direction());
    worst = std::max(worst, double(glm::length(f.toWorld(f.toLocal(w)) - w)));
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("samples of every non-specular BSDF follow its density") {
  Bsdfs::forEach([](auto type, int) {
    using T = typename decltype(type)::type;
    if constexpr ((T::possibleLobes & lobe::gathered) != 0) {
      CAPTURE(T::name);
      T const bsdf{};
      for (Vec3 wo : {Vec3(0, 0, 1), Vec3(0.6f, 0, 0.8f), Vec3(0.6f, -0.79f, 0.124f), Vec3(0, 0.6f, -0.8f)}) {
        TestRandom random(11);
        checkDirections(
            2, [&](Vec2 u) { return bsdf.sample(wo, random.vec2().x, u, Transport::flux).wi; },
            [&](Vec3 wi) { return bsdf.pdf(wo, wi); });
      }
    }
  });
}
