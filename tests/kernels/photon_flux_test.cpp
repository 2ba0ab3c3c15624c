// Energy of photon paths, path by path, without a density estimate.

#include <doctest/doctest.h>

#include <cmath>

#include "render/flatten/flatten.h"
#include "render/kernels/trace_photons.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

/// Sums what `count` photon paths deposit, by whether `here(position)` holds.
struct Sums {
  double inside = 0, outside = 0, squares = 0;
};

template <class Where>
Sums traceFlux(const Scene& scene, std::uint32_t count, bool direct, Where&& here) {
  HostScene const host(flatten(scene));
  cpu::FrameView frame;
  frame.scene = host.view();
  frame.maxDepth = hardDepthLimit;
  frame.seed = 7;
  frame.shadowRays = !direct;
  Tally tally;
  Sums sums;
  for (std::uint32_t path = 0; path < count; ++path) {
    double ofPath = 0;
    cpu::tracePhotonPath<feature::all>(
        frame, path, cpu::Real(count),
        [&](std::uint32_t, const cpu::PhotonPosition& p, const cpu::PhotonPower& power, cpu::Vec3) {
          double const flux = double(mean(power.flux));
          (here(Vec3d(p.p)) ? sums.inside : sums.outside) += flux;
          ofPath += flux;
        },
        tally);
    sums.squares += ofPath * ofPath;
  }
  CHECK(tally.truncated == 0);
  return sums;
}

/// Exact Fresnel reflectance in double, written for this test.
double fresnel(double cosI, double n) {
  double const sinT = std::sqrt(1 - cosI * cosI) / n, cosT = std::sqrt(1 - sinT * sinT);
  double const s = (cosI - n * cosT) / (cosI + n * cosT), p = (n * cosI - cosT) / (n * cosI + cosT);
  return (s * s + p * p) / 2;
}

/// Share of a cosine-distributed flux that passes a slab with all its inner reflections: (1 − R)/(1 + R) per direction.
double slabTransmittance(double n) {
  int const steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    double const sin2 = (i + 0.5) / steps, r = fresnel(std::sqrt(1 - sin2), n);
    sum += (1 - r) / (1 + r) / steps;
  }
  return sum;
}

}  // namespace

TEST_CASE("a closed room stores 1/(1 - albedo) times the emitted flux") {
  for (float albedo : {0.3f, 0.75f, 0.9f}) {
    CAPTURE(albedo);
    Scene scene = emptyScene(albedo);
    addBox(scene, {-1, -1, -1}, {1, 1, 1});
    addQuad(scene, {-0.25, 0.9, -0.25}, {0.5, 0, 0}, {0, 0, 0.5}, addMaterial(scene, DiffuseParams{Rgb(albedo)}))
        .emission = Emission{Rgb(2, 5, 11), Side::out};
    double const emitted = M_PI * 6 * 0.25;
    Sums const all = traceFlux(scene, 200000, true, [](Vec3d) { return true; });
    CHECK(all.inside == doctest::Approx(emitted / (1 - double(albedo))).epsilon(0.005));
  }
}

TEST_CASE("flux through a glass slab is the Fresnel quadrature") {
  for (double n : {1.33, 1.5, 2.0}) {
    CAPTURE(n);
    Scene scene = emptyScene(0);
    addBox(scene, {-1000, -1, -1000}, {1000, 1, 1000});
    addBox(scene, {-999, -0.11, -999}, {999, -0.1, 999}, addMaterial(scene, DielectricParams{float(n)}));
    addQuad(scene, {-0.01, 0, -0.01}, {0.02, 0, 0}, {0, 0, 0.02}).emission = Emission{Rgb(1), Side::out};
    double const emitted = M_PI * 0.02 * 0.02;
    Sums const flux = traceFlux(scene, 1u << 18, true, [](Vec3d p) { return p.y < -0.2; });
    CHECK(flux.inside / emitted == doctest::Approx(slabTransmittance(n)).epsilon(0.005));
    CHECK((flux.inside + flux.outside) / emitted == doctest::Approx(1).epsilon(0.001));
  }
}

TEST_CASE("direct deposits are left to shadow rays unless photons carry them") {
  Scene scene = emptyScene(0);  // black: a path is stored at most once, at its first surface
  addBox(scene, {-1, -1, -1}, {1, 1, 1});
  addSphere(scene, {0, 0, 0}, 0.1).emission = Emission{Rgb(1), Side::out};
  CHECK(traceFlux(scene, 1000, false, [](Vec3d) { return true; }).inside == 0);
  double const emitted = M_PI * 4 * M_PI * 0.01;
  CHECK(traceFlux(scene, 1000, true, [](Vec3d) { return true; }).inside == doctest::Approx(emitted).epsilon(1e-4));
}
