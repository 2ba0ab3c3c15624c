// Radii, counts and memory of the photon map.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "accel/photon_grid/grid_layout.h"
#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"
#include "render/flatten/flatten.h"
#include "render/photons/photon_plan.h"

namespace ropelight::families {
namespace {

/// A furnace by photons alone, at a radius that stays: 1 is seen, and 1 is gathered, times what the disc gains.
Settings furnaceSettings(double radius, std::uint64_t photons = 4096) {
  Settings settings = probeSettings(Mode::sppm, 16, photons);
  settings.radius = radius;
  settings.alpha = 1;
  settings.direct = DirectLight::photons;
  return settings;
}

Measurement furnace(Probe& probe, const char* series, double parameter, const Settings& settings, int iterations,
                    double bound = 0.01) {
  Estimate const e = probe.estimate(sphereFurnace(Rgb(0.5f), 1), settings, iterations, 8, meanOfAll);
  double const expected = 1 + (settings.alpha == 1 ? discGain(settings.radius) : 1);
  return {series, parameter, e.mean / expected, e.error / expected, 1, bound};
}

std::vector<Measurement> radii(Probe& probe) {
  std::vector<Measurement> out;
  for (double radius : {3e-3, 3e-2, 0.3, 1.0, 4.0, 100.0}) {
    // A disc of 0.003 holds .04 of 4096 photons with two bounces each, one of 100 a quarter.
    int const iterations = radius < 0.01 ? probe.choose(128, 512) : (radius > 0.5 ? 4 : 32);
    out.push_back(furnace(probe, "sppm", radius, furnaceSettings(radius), iterations, radius < 0.01 ? 0.02 : 0.01));
  }
  return out;
}

/// Radii below what floats can tell apart do no harm: what is not gathered is dark, and nothing is not finite.
std::vector<Measurement> tinyRadius(Probe& probe) {
  std::vector<Measurement> out;
  for (double radius : {1e-4, 1e-8, 1e-12, 1e-30}) {
    Image const image = probe.render(sphereFurnace(Rgb(0.5f), 1), furnaceSettings(radius), 4).image;
    double least = 1e300, most = 0;
    for (Rgb p : image.pixels) {
      least = std::min(least, double(p.x));
      most = std::max(most, double(p.x));
    }
    out.push_back({"darkest pixel", radius, std::min(least, 1.0), 0, 1, 1e-6});  // its emission is never lost
    out.push_back({"brightest pixel is finite", radius, std::isfinite(most) ? 0.0 : 1.0});
  }
  return out;
}

/// The radius after n iterations: r₁² ∏ (k + α)/(k + 1), of which α = 1 leaves r₁ (Knaus & Zwicker 2011).
std::vector<Measurement> alphas(Probe& probe) {
  std::vector<Measurement> out;
  for (double alpha : {0.01, 0.5, 1.0}) {
    Settings settings = furnaceSettings(0.3, 4096);
    settings.alpha = alpha;
    int const n = 32;
    double square = 0.09;
    for (int k = 1; k < n; ++k) square *= (k + alpha) / (k + 1);
    Rendered const r = probe.render(sphereFurnace(Rgb(0.5f), 1), settings, n);
    out.push_back({"radius / closed form", alpha, r.stats.radius / std::sqrt(square), 0, 1, 1e-6});
    out.push_back(furnace(probe, "radiance / closed form", alpha, settings, 64, 0.02));
  }
  return out;
}

/// The variance of n iterations falls as 1/n where the radius stays.
std::vector<Measurement> varianceOfFixedRadius(Probe& probe) {
  Settings settings = furnaceSettings(0.3, 512);
  settings.sampler = SamplerKind::independent;
  int const runs = probe.choose(64, 256);
  auto const variance = [&](int iterations) {
    Estimate const e = probe.estimate(sphereFurnace(Rgb(0.5f), 1), settings, iterations, runs, meanOfAll);
    return e.error * e.error;
  };
  double const ratio = variance(2) / variance(16);
  // The ratio of two variances of m values each has a relative standard error of 2/√(m − 1).
  double const error = 2 / std::sqrt(runs - 1.0);
  return {{"independent numbers", 8, ratio / 8, error, 1, error}};
}

/// Everything in one cell, and cells far smaller than the discs: the same film.
std::vector<Measurement> cells(Probe& probe) {
  std::vector<Measurement> out;
  Image const expected = probe.render(sphereFurnace(Rgb(0.5f), 1), furnaceSettings(0.3, 8192), 4).image;
  for (double size : {0.25, 1.0, 4.0, 16.0}) {
    Settings settings = furnaceSettings(0.3, 8192);
    settings.cellSize = size;
    Image const image = probe.render(sphereFurnace(Rgb(0.5f), 1), settings, 4).image;
    double worst = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      worst = std::max(worst, std::abs(double(image.pixels[i].x) / double(expected.pixels[i].x) - 1));
    out.push_back({"largest relative difference", size, worst, 0, 0, 1e-4});
  }
  return out;
}

/// Rows of a hashed grid that share table entries within one query, so that their photons are met more than once: how
/// many of the rows within `reach` rows of (y, z) start within that many entries of another's start.
int collidingRows(const cpu::PhotonGrid& grid, int y, int z, int reach) {
  std::vector<std::uint32_t> starts;
  for (int dz = -reach; dz <= reach; ++dz)
    for (int dy = -reach; dy <= reach; ++dy) starts.push_back(grid.rowStart(y + dy, z + dz) & (grid.cells - 1));
  int found = 0;
  std::sort(starts.begin(), starts.end());
  for (std::size_t i = 1; i < starts.size(); ++i) found += starts[i] - starts[i - 1] <= 1;
  return found;
}

struct Crowd {
  Vec3d place{0};
  int collisions = 0;
};

/// Where, of a million places within a box about the middle, most rows collide.
Crowd worstPlace(const cpu::PhotonGrid& grid, Vec3d middle, double halfSize) {
  Crowd worst;
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> at(-halfSize, halfSize);
  for (int i = 0; i < 1000000; ++i) {
    Vec3d const p = middle + Vec3d(at(engine), at(engine), at(engine));
    cpu::Vec3 const f(p);
    int const n = collidingRows(grid, grid.cellOf(f.y, 1), grid.cellOf(f.z, 2), 4);
    if (n > worst.collisions) worst = {p, n};
  }
  return worst;
}

/// A furnace somewhere in a scene so wide that its grid is hashed, seen from its centre towards +x, so that
/// discs lie across the rows; place: of the wall that is seen.
Scene furnaceFarOff(Vec3d place, double halfSize) {
  Scene scene = sphereFurnace(Rgb(0.5f), 1);
  Vec3d const center = place - Vec3d(1, 0, 0);
  scene.shapes[0].toWorld[3] = glm::dvec4(center, 1);
  int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
  for (double side : {-halfSize, halfSize}) addSphere(scene, Vec3d(side), 1, black);
  lookAt(scene, center, place, {0, 1, 0}, 5);
  return scene;
}

std::vector<Measurement> collisions(Probe& probe) {
  double const halfSize = 500, radius = 0.3;
  Settings settings = furnaceSettings(radius, 8192);
  settings.cellSize = 0.25;  // a disc covers nine rows by nine, but for its corners
  FlatScene const flat = flatten(furnaceFarOff(Vec3d(0), halfSize));
  cpu::PhotonGrid grid;
  cpu::layOut(grid, flat.bounds, radius * settings.cellSize, cpu::tableFor(settings.photons));
  Crowd const crowd = worstPlace(grid, -flat.origin, 0.9 * halfSize);
  Estimate const e =
      probe.estimate(furnaceFarOff(crowd.place + flat.origin, halfSize), settings, probe.choose(32, 128), 8, meanOfAll);
  double const expected = 1 + discGain(radius);
  return {
      {"rows are hashed, and some collide", double(crowd.collisions), !grid.dense && crowd.collisions >= 4 ? 0.0 : 1.0},
      {"radiance / closed form", double(crowd.collisions), e.mean / expected, e.error / expected, 1, 0.01}};
}

/// One photon an iteration, and as many as there are bits for.
std::vector<Measurement> counts(Probe& probe) {
  std::vector<Measurement> out;
  out.push_back(furnace(probe, "sppm", 1, furnaceSettings(1, 1), probe.choose(4096, 32768), 0.03));
  out.push_back(furnace(probe, "sppm", 100, furnaceSettings(0.5, 100), 1024, 0.02));
  if (probe.isGpu() && !probe.isShort())
    out.push_back(furnace(probe, "sppm", 1e8, furnaceSettings(0.03, 100000000), 1));
  return out;
}

/// k-nearest gathers with fewer photons than k.
std::vector<Measurement> fewerThanK(Probe& probe) {
  std::vector<Measurement> out;
  for (std::uint64_t photons : {std::uint64_t(1), std::uint64_t(16), std::uint64_t(64)}) {
    Settings settings = furnaceSettings(1, photons);
    settings.gather = GatherBy::nearest;
    settings.nearest = 128;
    out.push_back(furnace(probe, "sppm, k = 128", double(photons), settings, probe.choose(1024, 8192), 0.03));
  }
  return out;
}

/// Photons that hit nothing, and no light at all: what is seen is exact, and nothing is stored.
std::vector<Measurement> nothing(Probe& probe) {
  Scene away = emptyScene(0.5f);
  addQuad(away, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  addQuad(away, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}).emission = Emission{Rgb(1), Side::out};  // upwards
  lookAt(away, {0, 0.5, 3}, {0, 0, 0}, {0, 1, 0}, 20);
  Scene dark = away;
  dark.shapes[1].emission.reset();
  std::vector<Measurement> out;
  for (DirectLight direct : {DirectLight::shadow, DirectLight::photons}) {
    Settings settings = probeSettings(Mode::sppm, 16, 4096);
    settings.direct = direct;
    Rendered const a = probe.render(away, settings, 4), b = probe.render(dark, settings, 4);
    out.push_back({"they never land", 0, meanOfAll(a.image)});
    out.push_back({"photons stored", 0, double(a.stats.photonsStored)});
    out.push_back({"no light", 0, meanOfAll(b.image)});
  }
  return out;
}

/// Little memory makes an iteration many passes; the film is that of one.
std::vector<Measurement> memory(Probe& probe) {
  Settings settings = furnaceSettings(0.1, 262144);
  Rendered const one = probe.render(sphereFurnace(Rgb(0.5f), 1), settings, 2);
  settings.photonMemory = 1;
  Rendered const many = probe.render(sphereFurnace(Rgb(0.5f), 1), settings, 2);
  double worst = 0;
  for (std::size_t i = 0; i < one.image.pixels.size(); ++i)
    worst = std::max(worst, std::abs(double(many.image.pixels[i].x) / double(one.image.pixels[i].x) - 1));
  return {{"largest relative difference", double(many.stats.chunks), worst, 0, 0, 1e-4},
          {"in one pass", 1, many.stats.chunks > 1 ? 0.0 : 1.0}};
}

}  // namespace

StressFamily photons() {
  return {
      "photons",
      "radii, counts and memory of the photon map",
      {{"radii", "from a few photons a disc to discs larger than the scene", "radius / the sphere's",
        "radiance / closed form", "1 + the sphere's area within the disc over pi r^2", "1%; 2% at the smallest", true,
        radii},
       {"tiny radius", "radii below the spacing of floats", "radius", "what is left of a pixel", "its own emission, 1",
        "1e-6", true, tinyRadius},
       {"alpha", "alpha of 0.01 and 1", "alpha", "radius and radiance / closed form",
        "Knaus & Zwicker's product; 1/(1 - albedo)", "1e-6; 2%", true, alphas},
       {"fixed radius", "alpha 1: the variance falls as 1/n", "ratio of iterations", "ratio of variances / ratio", "1",
        "one standard error of the ratio, and four more", false, varianceOfFixedRadius},
       {"cells", "cells of a quarter and of sixteen radii: all photons in one", "cell size / radius",
        "largest difference from cells of one radius", "0", "1e-4: sums in another order", true, cells},
       {"collisions", "rows of the hashed grid that collide within one disc", "colliding rows of 81",
        "radiance / closed form", "1 + the sphere's area within the disc over pi r^2", "1%", true, collisions},
       {"counts", "1 photon an iteration, and 1e8 on a GPU", "photons an iteration", "radiance / closed form",
        "1/(1 - albedo)", "3%, 2%, 1%", true, counts},
       {"fewer than k", "k-nearest gathers with fewer photons than k", "photons an iteration", "radiance / closed form",
        "1 + the sphere's area within the largest disc over pi r^2", "3%", true, fewerThanK},
       {"nothing", "photons that never land, no light at all", "", "radiance, photons", "0", "0", true, nothing},
       {"memory", "1 MiB for photons", "passes", "largest difference from one pass", "0", "1e-4: sums in another order",
        true, memory}}};
}

}  // namespace ropelight::families
