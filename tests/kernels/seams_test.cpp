// What the core is ready for before a scene can ask for it: a glossy BSDF, a light without a place, coordinates on
// surfaces. This unit compiles its own copy of the kernels, with a dummy of each in the lists.

#define ROPELIGHT_TEST_TARGET cpu_seams
#define RL_TEST_BSDFS , Phong
#define RL_TEST_EMITTERS , ConstantSky
namespace ropelight::cpu_seams {
struct Phong;
struct ConstantSky;
}  // namespace ropelight::cpu_seams

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "render/backend/cpu_backend.h"
// the kernels, on that backend:
#include "render/flatten/flatten.h"
#include "render/integrators/photon_bins.h"
#include "render/kernels/gather_glossy.h"
#include "render/kernels/trace_path.h"
#include "render/kernels/trace_photons.h"
#include "render/photons/photon_plan.h"
#include "render/upload/upload.h"
#include "tests/scenes/seams.h"
#include "tests/support/rendering.h"

namespace ropelight::cpu_seams {
namespace {

using testing::addQuad;
using testing::addSphere;
using testing::emptyScene;

constexpr FeatureBits F = feature::quads | feature::spheres | feature::diffuse | feature::lights | feature::photons |
                          feature::glossy | feature::shading | feature::environment;
constexpr int resolution = 32;

/// The kernels over one scene on the CPU. Its materials and lights may be replaced before anything is traced.
struct Bench {
  Backend backend{BackendChoice{}};
  SceneStructures structures;
  DeviceScene<Backend> scene;
  FrameView frame;
  std::vector<Material> materials;

  explicit Bench(const Scene& host) : structures(of(host)), scene(backend, structures) {
    frame.scene = scene.view;
    frame.camera = makeCamera(structures.flat->inFrame(host.camera), resolution, resolution);
    frame.width = frame.height = resolution;
    frame.maxDepth = 6;
    frame.seed = 7;
    materials.assign(frame.scene.materials.data, frame.scene.materials.data + frame.scene.materials.size);
  }

  static SceneStructures of(const Scene& host) {
    SceneStructures s;
    s.flat = std::make_shared<const FlatScene>(flatten(host));
    return s;
  }

  void replaceMaterial(int index, const Material& m) {
    materials[std::size_t(index)] = m;
    frame.scene.materials = {materials.data(), std::uint32_t(materials.size())};
  }

  /// Mean over the image of `iterations` runs of a stage that fills one film.
  template <class Run>
  double mean(int iterations, Run&& run) {
    std::vector<Rgb> film(frame.slots());
    double sum = 0;
    for (int i = 0; i < iterations; ++i) {
      frame.iteration = std::uint32_t(i);
      run(Span<Rgb>{film.data(), frame.slots()});
      for (Rgb c : film) sum += double(c.y);
    }
    return sum / (double(iterations) * resolution * resolution);
  }
};

struct Photons {
  std::vector<Photon> all;
  std::vector<std::uint32_t> directions;
};

Photons tracePhotons(const Bench& b, std::uint32_t iteration, std::uint32_t paths) {
  Photons found;
  Tally tally;
  for (std::uint32_t path = 0; path < paths; ++path)
    tracePhotonPath<F>(
        b.frame, std::uint64_t(iteration) * paths + path, Real(paths),
        [&](std::uint32_t, const PhotonPosition& at, const PhotonPower& power, Vec3 w) {
          found.all.push_back({at, power});
          found.directions.push_back(packDirection(w));
        },
        tally);
  return found;
}

/// Photons in a grid with their directions, and what was gathered from them.
void gather(Bench& b, const Photons& photons, Real radius, const std::vector<GatherPoint>& points,
            const std::vector<GlossyPoint>& glossy, Span<Rgb> film) {
  std::uint32_t const n = std::uint32_t(photons.all.size()), table = tableFor(n);
  PhotonBins<Backend> bins;
  bins.allocate(b.backend, n, table, true);
  bins.layOut(b.structures.flat->bounds, double(radius), table);
  for (std::uint32_t k = 0; k < n; ++k) {
    bins.keys()[k] = bins.grid().key(photons.all[k].position.p);
    bins.slots()[k] = k;
  }
  IterationState state;
  state.chunkPhotons = n;
  bins.sort(b.backend, {photons.all.data(), n}, {&state, 1}, {photons.directions.data(), n});
  std::uint32_t const slots = b.frame.slots();
  b.backend.forEach(slots, GatherGlossy<F>{GatherGlossyArgs{GatherView{bins.grid(), radius, b.frame.maxDepth},
                                                            b.frame.scene.materials,
                                                            {points.data(), slots},
                                                            {glossy.data(), slots},
                                                            film}});
}

/// The mistake that the direction of photons is there to prevent.
void weighTowardsNormal(const Bench& b, std::vector<GatherPoint>& points, std::vector<GlossyPoint>& glossy) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (glossy[i].material == GlossyPoint::none) continue;
    Frame const local(glossy[i].inner ? -points[i].n : points[i].n);
    visitBsdf<F>(b.frame.scene.materials[glossy[i].material], [&](const auto& bsdf) {
      Vec3 const wo = local.toLocal(glossy[i].back);
      points[i].weight *= bsdf.eval(wo, Vec3(0, 0, std::copysign(Real(1), wo.z)));
    });
    glossy[i].material = GlossyPoint::none;
  }
}

double photonMapped(Bench& b, int iterations, std::uint32_t paths, Real radius, bool asLambertian) {
  std::vector<GatherPoint> points(b.frame.slots());
  std::vector<GlossyPoint> glossy(b.frame.slots());
  return b.mean(iterations, [&](Span<Rgb> film) {
    std::uint32_t const slots = b.frame.slots();
    b.backend.forEach(slots, TraceCamera<F>{{b.frame, film, {points.data(), slots}, {glossy.data(), slots}}});
    if (asLambertian) weighTowardsNormal(b, points, glossy);
    gather(b, tracePhotons(b, b.frame.iteration, paths), radius, points, glossy, film);
  });
}

/// A glossy floor that sees a lit wall; the light itself stands above, out of the mirror direction.
Scene glossyFloor() {
  Scene scene = emptyScene(0.8f);
  addQuad(scene, {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, testing::addMaterial(scene, DiffuseParams{}));
  addQuad(scene, {-2, 0, -2}, {4, 0, 0}, {0, 3, 0});
  addQuad(scene, {-0.5, 2.9, -1.5}, {1, 0, 0}, {0, 0, 1}).emission = Emission{Rgb(8.0f), Side::both};
  testing::lookAt(scene, {0, 1.2, 2.2}, {0, 0, 0.2}, {0, 1, 0}, 30);
  return scene;
}

}  // namespace

TEST_CASE("seam: photons on a glossy surface are weighed by their direction") {
  Bench b(glossyFloor());
  Phong phong;
  b.replaceMaterial(1, materialOf(phong));
  CHECK(b.materials[1].glossy());
  CHECK(!b.materials[1].specular());
  double const path = b.mean(400, [&](Span<Rgb> film) {
    b.backend.forEach(b.frame.slots(), TracePath<F>{{b.frame, film}});
  });
  double const mapped = photonMapped(b, 24, 20000, Real(0.08), false);
  double const lambertian = photonMapped(b, 4, 20000, Real(0.08), true);
  CHECK(mapped == doctest::Approx(path).epsilon(0.02));
  CHECK(std::abs(lambertian / path - 1) > 0.1);  // the check can fail
}

TEST_CASE("seam: a light without a place lights a sphere as it should") {
  constexpr float albedo = 0.6f;
  Scene host = emptyScene(albedo);
  addSphere(host, {0, 0, 0}, 1);
  testing::lookAt(host, {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 20);
  Bench b(host);
  Light const sky{std::uint16_t(Emitters::indexOf<ConstantSky>()), 1, noPrimitive, Rgb(1.0f), 0, 1};
  Real const cdf = 1;
  std::uint32_t const guide = 0;
  b.frame.scene.lights = {&sky, 1};
  b.frame.scene.lightCdf = {&cdf, 1};
  b.frame.scene.lightGuide = {&guide, 1};
  auto const path = [&](Span<Rgb> film) { b.backend.forEach(b.frame.slots(), TracePath<F>{{b.frame, film}}); };
  auto const ray = [&](Span<Rgb> film) { b.backend.forEach(b.frame.slots(), TraceCamera<F>{{b.frame, film, {}, {}}}); };
  CHECK(b.mean(64, path) == doctest::Approx(albedo).epsilon(0.005));  // a convex body sees nothing but the sky
  CHECK(b.mean(64, ray) == doctest::Approx(albedo).epsilon(0.01));
  testing::lookAt(host, {0, 0, 4}, {0, 0, 8}, {0, 1, 0}, 20);
  b.frame.camera = makeCamera(host.camera, resolution, resolution);
  CHECK(b.mean(1, path) == doctest::Approx(1));
  CHECK(b.mean(1, ray) == doctest::Approx(1));
}

TEST_CASE("seam: coordinates on surfaces lead back to the point") {
  Scene host = emptyScene(0.5f);
  addQuad(host, {-1, -1, 0.5}, {2, 0, 0}, {0, 2, 0.5});
  addSphere(host, {0, 0, -3}, 1);
  Bench b(host);
  for (int i = 0; i < 64; ++i) {
    Vec3 const target(Real(0.1 * (i % 8) - 0.35), Real(0.1 * (i / 8) - 0.35), 0);
    for (Real z : {Real(4), Real(-8)}) {
      Ray const ray{Vec3(0, 0, z), target - Vec3(0, 0, z), infinity};
      Hit const hit = closestHit<F>(b.frame.scene, ray);
      REQUIRE(hit.found());
      Surface const s = surfaceAt<F>(b.frame.scene, ray, hit);
      CHECK(double(length(s.tangent)) == doctest::Approx(1).epsilon(1e-5));
      CHECK(std::abs(double(dot(s.tangent, s.n))) < 1e-4);
      CHECK(s.shadingNormal == s.n);
      CHECK(double(length(pointAt(s) - s.p)) < 1e-4);
    }
  }
}

}  // namespace ropelight::cpu_seams
