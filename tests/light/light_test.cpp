// Light sampling: points by area, directions by solid angle, photons by power.

#include <doctest/doctest.h>

#include "render/light/lights.h"
#include "render/scene/ellipsoid.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/chi_square.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr int samples = 50000;
constexpr int tests = 40;  // χ² tests in this file, at most

double turn(Vec3d v) {
  double const a = std::atan2(v.y, v.x) / (2 * M_PI);
  return a < 0 ? a + 1 : a;
}

Vec3d fromTurn(double phi, double z) {
  double const r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(2 * M_PI * phi), r * std::sin(2 * M_PI * phi), z};
}

Mat3d linear(const Mat4d& m) { return Mat3d(m); }

/// Ellipsoids: sphere, oblate, prolate, with three axes and turned, sheared, and as thin as a disc or needle.
std::vector<Mat3d> ellipsoids() {
  Mat3d const turned = linear(rotation({1, 2, 3}, 40));
  Mat3d shear(1.0);
  shear[1][0] = 0.8;
  return {linear(scaling({2, 2, 2})),
          linear(scaling({1, 1, 0.3})),
          linear(scaling({0.5, 0.5, 2})),
          turned * linear(scaling({1, 0.4, 2})),
          turned * shear,
          turned * linear(scaling({1, 1, 0.01})),
          turned * linear(scaling({0.02, 0.02, 1}))};
}

Sphere sphereOf(const Mat3d& m, Vec3d center) { return toTarget(FlatSphere{m, center}); }

/// Whether the ray o + t d, t > 0, meets the ellipsoid, and where it does first.
bool meets(const Mat3d& toWorld, Vec3d center, Vec3d o, Vec3d d, Vec3d& p) {
  Mat3d const inverse = glm::inverse(toWorld);
  Vec3d const q = inverse * (o - center), v = inverse * d;
  double const a = glm::dot(v, v), b = glm::dot(q, v), disc = b * b - a * (glm::dot(q, q) - 1);
  if (disc < 0) return false;
  double const t = glm::dot(q, q) > 1 ? (-b - std::sqrt(disc)) / a : (-b + std::sqrt(disc)) / a;
  p = o + t * d;
  return t > 0;
}

/// Whether the ray meets the parallelogram corner + s e1 + t e2, and where.
bool meets(const FlatQuad& quad, Vec3d o, Vec3d d, Vec3d& p) {
  Vec3d const e1 = quad.corner[1] - quad.corner[0], e2 = quad.corner[3] - quad.corner[0];
  Vec3d const x = glm::inverse(Mat3d(e1, e2, -d)) * (o - quad.corner[0]);
  p = o + x.z * d;
  return x.x >= 0 && x.x <= 1 && x.y >= 0 && x.y <= 1 && x.z > 0;
}

/// Draws directions from a point to a light and compares their histogram with pdf(w), which is 0 where w misses.
/// sample: returns the sampled point and the density that came with it, 0 where the sample was in vain.
template <class Draw, class Pdf>
void checkToward(Vec3d from, Vec3d towards, Draw&& draw, Pdf&& pdf) {
  TestRandom random(21);
  Mat3d frame;
  frame[2] = glm::normalize(towards);
  frame[0] = glm::normalize(glm::cross(frame[2], Vec3d(0.3, 0.5, 0.7)));
  frame[1] = glm::cross(frame[2], frame[0]);
  std::vector<Vec3d> local;
  double lowest = 1, worst = 0;
  for (int i = 0; i < samples; ++i) {
    auto const [p, density] = draw(random.vec2());
    if (density == 0) continue;
    Vec3d const w = glm::normalize(Vec3d(p) - from);
    local.push_back(glm::transpose(frame) * w);
    lowest = std::min(lowest, local.back().z);
    worst = std::max(worst, std::abs(density / pdf(w, &p) - 1));
  }
  CHECK(worst < 2e-3);
  double const range = std::min(2.0, (1 - lowest) * 1.02);
  Histogram2 histogram(12, 10);
  for (Vec3d v : local) histogram.add(turn(v), (1 - v.z) / range);
  std::vector<double> expected = histogram.expected(
      32, [&](double phi, double h) { return pdf(frame * fromTurn(phi, 1 - range * h), nullptr) * 2 * M_PI * range; });
  double const useful = double(local.size()) / samples;  // the density's integral, since it is that of all samples
  CHECK(sum(expected) == doctest::Approx(useful * double(local.size())).epsilon(0.01));
  for (double& e : expected) e /= useful;
  CHECK(chiSquareP(histogram.counts, expected) > significance(tests));
}

}  // namespace

TEST_CASE("points on a quad are uniform by area and carry its normal") {
  FlatQuad const flat{{{1, 2, 3}, {3, 2, 4}, {4, 5, 4}, {2, 5, 3}}};
  Quad const quad = toTarget(flat);
  TestRandom random(1);
  Histogram2 histogram(16, 16);
  Mat3d const inverse =
      glm::inverse(Mat3d(flat.corner[1] - flat.corner[0], flat.corner[3] - flat.corner[0],
                         glm::cross(flat.corner[1] - flat.corner[0], flat.corner[3] - flat.corner[0])));
  double off = 0;
  for (int i = 0; i < samples; ++i) {
    Surface s;
    QuadLight::samplePoint(quad, random.vec2(), s);
    Vec3d const x = inverse * (Vec3d(s.p) - flat.corner[0]);
    histogram.add(x.x, x.y);
    off = std::max({off, std::abs(x.z), glm::length(glm::cross(Vec3d(s.n), glm::normalize(Vec3d(-3, 1, 6))))});
  }
  CHECK(off < 1e-5);
  CHECK(histogram.uniformP() > significance(tests));
}

TEST_CASE("points on every ellipsoid are uniform by area, on it, with its outward normal") {
  Vec3d const center(3, -2, 1);
  for (const Mat3d& m : ellipsoids()) {
    CAPTURE(m[2].z);
    Sphere const sphere = sphereOf(m, center);
    Mat3d const inverse = glm::inverse(m);
    TestRandom random(2);
    Histogram2 histogram(12, 12);
    double off = 0, turned = 0, beyond = 0;
    for (int i = 0; i < samples; ++i) {
      Surface s;
      SphereLight::samplePoint(sphere, random.vec2(), s);
      Vec3d const local = inverse * (Vec3d(s.p) - center);
      Vec3d const unit = glm::normalize(local);
      histogram.add(turn(unit), 0.5 - 0.5 * unit.z);
      off = std::max(off, std::abs(glm::length(local) - 1));
      turned = std::max(turned, 1 - glm::dot(Vec3d(s.n), glm::normalize(glm::transpose(inverse) * unit)));
      double const distance = std::abs(glm::length(local) - 1) / glm::length(glm::transpose(inverse) * unit);
      beyond = std::max(beyond, distance - glm::dot(glm::abs(Vec3d(s.n)), Vec3d(s.error)));
    }
    // |det M| |M⁻ᵀ n| is the ratio of the areas.
    double const area = ellipsoidArea(m);
    std::vector<double> const expected = histogram.expected(8, [&](double phi, double h) {
      return 4 * M_PI * std::abs(glm::determinant(m)) *
             glm::length(glm::transpose(inverse) * fromTurn(phi, 1 - 2 * h)) / area;
    });
    CHECK(sum(expected) == doctest::Approx(samples).epsilon(1e-3));
    CHECK(chiSquareP(histogram.counts, expected) > significance(tests));
    CHECK(off < 1e-4);
    CHECK(beyond <= 0);
    CHECK(turned < 1e-2);
  }
}

TEST_CASE("bands of a spheroid get their closed-form share of the points") {
  for (double c : {0.2, 3.0}) {
    CAPTURE(c);
    Sphere const sphere = sphereOf(linear(scaling({1, 1, c})), Vec3d(0));
    // dA = 2π √(1 + k z²) dz with k = (1 − c²)/c⁴ for an equator of radius 1.
    double const k = (1 - c * c) / (c * c * c * c), root = std::sqrt(std::abs(k));
    auto const below = [&](double z) {
      double const x = root * z;
      return M_PI * (z * std::sqrt(1 + k * z * z) + (k > 0 ? std::asinh(x) : std::asin(x)) / root);
    };
    double const area = below(c) - below(-c);
    CHECK(ellipsoidArea(linear(scaling({1, 1, c}))) == doctest::Approx(area).epsilon(1e-9));
    constexpr int bands = 24;
    std::vector<std::uint64_t> observed(bands, 0);
    std::vector<double> expected;
    TestRandom random(3);
    for (int i = 0; i < samples; ++i) {
      Surface s;
      SphereLight::samplePoint(sphere, random.vec2(), s);
      ++observed[std::size_t(std::clamp(int((double(s.p.z) / c + 1) / 2 * bands), 0, bands - 1))];
    }
    for (int b = 0; b < bands; ++b)
      expected.push_back(samples / area * (below(c * (2.0 * (b + 1) / bands - 1)) - below(c * (2.0 * b / bands - 1))));
    CHECK(chiSquareP(observed, expected) > significance(tests));
  }
}

TEST_CASE("directions to a quad follow their density") {
  FlatQuad const flat{{{-1, -1, 2}, {1, -1, 2}, {1.5, 1, 2}, {-0.5, 1, 2}}};
  Quad const quad = toTarget(flat);
  for (Vec3d from : {Vec3d(0, 0, 0), Vec3d(4, 1, 1.5), Vec3d(0.2, 0.3, 1.7), Vec3d(0, 0, 30)}) {
    CAPTURE(from.z);
    Vec3 const eye(from);
    checkToward(
        from, Vec3d(0.25, 0, 2) - from,
        [&](Vec2 u) {
          Surface s;
          Vec3 toward;
          double const pdf = double(QuadLight::sampleToward(quad, 4, {eye}, u, s, toward));
          return std::pair(eye + toward, pdf);
        },
        [&](Vec3d w, const Vec3* p) {
          Vec3d hit;
          if (p) return double(QuadLight::pdfToward(quad, 4, eye, Surface{}, *p - eye));
          return meets(flat, from, w, hit) ? double(QuadLight::pdfToward(quad, 4, eye, Surface{}, Vec3(hit - from)))
                                           : 0.0;
        });
  }
}

TEST_CASE("a quad seen edge-on offers nothing") {
  Quad const quad = toTarget(FlatQuad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  Surface s;
  Vec3 toward;
  CHECK(QuadLight::sampleToward(quad, 1, {Vec3(3, 0.5f, 0)}, Vec2(0.3f, 0.4f), s, toward) == 0);
  CHECK(QuadLight::sampleToward(quad, 1, {Vec3(0.5f, 0.5f, 0)}, Vec2(0.3f, 0.4f), s, toward) == 0);
}

TEST_CASE("directions to every ellipsoid follow their density, from afar, near and inside") {
  Vec3d const center(0.5, -1, 2);
  for (const Mat3d& m : ellipsoids()) {
    if (singularValues(m).z < 0.1) continue;  // bins cannot resolve needles
    Sphere const sphere = sphereOf(m, center);
    for (double distance : {6.0, 1.05, 0.5}) {
      CAPTURE(m[2].z);
      CAPTURE(distance);
      Vec3d const from = Vec3d(Vec3(center + m * (distance * glm::normalize(Vec3d(1, -2, 1.5)))));
      Vec3 const eye(from);
      checkToward(
          from, center - from,
          [&](Vec2 u) {
            Surface s;
            Vec3 toward;
            double const pdf = double(SphereLight::sampleToward(sphere, 1, {eye}, u, s, toward));
            return std::pair(s.p, pdf);
          },
          [&](Vec3d w, const Vec3* p) {
            Vec3d hit;
            if (!p && !meets(m, center, from, w, hit)) return 0.0;
            Vec3 const at = p ? *p : Vec3(hit);
            Surface on;
            placeOn(sphere, sphere.toObject * (at - sphere.center), on);
            return double(SphereLight::pdfToward(sphere, 1, eye, on, at - eye));
          });
    }
  }
}

TEST_CASE("a sampled point of an ellipsoid is on it, on the side that is seen") {
  TestRandom random(6);
  for (const Mat3d& m : ellipsoids()) {
    CAPTURE(m[2].z);
    Sphere const sphere = sphereOf(m, Vec3d(0));
    double off = 0;
    int hidden = 0, wrong = 0;
    for (int i = 0; i < 5000; ++i) {
      double const distance = random.between(0.05, 4);
      Vec3 const from(m * (random.direction() * distance));
      Surface s;
      Vec3 toward;
      Real const pdf = SphereLight::sampleToward(sphere, 1, {from}, random.vec2(), s, toward);
      off = std::max(off, std::abs(glm::length(glm::inverse(m) * Vec3d(s.p)) - 1));
      // Facing the eye from outside and turned away from it within, but for the last hair at the silhouette.
      Vec3d const seen = glm::normalize(glm::inverse(m) * Vec3d(s.p)), eye = glm::inverse(m) * Vec3d(from);
      double const facing = glm::dot(seen, glm::normalize(eye - seen));
      hidden += std::abs(distance - 1) > 0.01 && (distance > 1 ? facing < -2e-3 : facing > 2e-3);
      wrong += !isFinite(pdf) || !(pdf > 0);
    }
    CHECK(off < 1e-4);
    CHECK(hidden == 0);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a distant sphere keeps its solid angle") {
  Sphere const sphere = sphereOf(Mat3d(1.0), Vec3d(0));
  for (double distance : {10.0, 1e3, 1e6}) {
    Surface s;
    Vec3 toward;
    double const pdf =
        double(SphereLight::sampleToward(sphere, 1, {Vec3(0, 0, Real(distance))}, Vec2(0.4f, 0.8f), s, toward));
    double const sine2 = 1 / (distance * distance), angle = 2 * M_PI * sine2 / (1 + std::sqrt(1 - sine2));
    CHECK(pdf * angle == doctest::Approx(1).epsilon(1e-5));
  }
}
