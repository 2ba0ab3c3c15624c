#include "tests/support/rendering.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "render/film/metrics.h"

namespace ropelight::testing {
namespace {

Vec3d vec(oracle::Vec v) { return {v.x, v.y, v.z}; }
Rgb rgb(const oracle::Rgb& c) { return Rgb(float(c[0]), float(c[1]), float(c[2])); }

MaterialDesc material(const oracle::Shape& s) {
  if (auto const* d = std::get_if<oracle::Diffuse>(&s.material)) return DiffuseParams{rgb(d->albedo)};
  if (auto const* m = std::get_if<oracle::Mirror>(&s.material)) return MirrorParams{rgb(m->reflectance)};
  auto const& g = std::get<oracle::Dielectric>(s.material);
  return DielectricParams{float(g.ior), rgb(g.reflectance), rgb(g.transmittance)};
}

ShapeDesc& addTriangle(Scene& scene, const oracle::Triangle& t, int material) {
  Mesh mesh;
  mesh.positions = {vec(t.a), vec(t.b), vec(t.c)};
  mesh.triangles = {{0, 1, 2}};
  return addMesh(scene, std::move(mesh), material);
}

ShapeDesc& addShape(Scene& scene, const oracle::Shape& s, int material) {
  if (auto const* ball = std::get_if<oracle::Sphere>(&s.geometry))
    return addSphere(scene, vec(ball->center), ball->radius, material);
  if (auto const* quad = std::get_if<oracle::Parallelogram>(&s.geometry))
    return addQuad(scene, vec(quad->corner), vec(quad->edge1), vec(quad->edge2), material);
  return addTriangle(scene, std::get<oracle::Triangle>(s.geometry), material);
}

}  // namespace

Scene fromOracle(const oracle::Scene& from) {
  Scene scene;
  lookAt(scene, vec(from.camera.position), vec(from.camera.target), vec(from.camera.up), from.camera.verticalFov);
  scene.camera.apertureRadius = from.camera.aperture;
  scene.camera.focusDistance = from.camera.focus;
  scene.film = {from.camera.width, from.camera.height};
  for (const oracle::Shape& s : from.shapes) {
    ShapeDesc& shape = addShape(scene, s, addMaterial(scene, material(s)));
    Rgb const radiance = rgb(s.emission.radiance);
    if (isBlack(radiance)) continue;
    Side const side = s.emission.side == oracle::Side::front  ? Side::out
                      : s.emission.side == oracle::Side::back ? Side::in
                                                              : Side::both;
    shape.emission = Emission{radiance, side};
  }
  return scene;
}

Settings settingsFor(Mode mode, int width, int height) {
  Settings s;
  s.mode = mode;
  s.width = width;
  s.height = height;
  return s;
}

Image renderImage(const Scene& scene, const Settings& settings, int iterations, Stats* stats,
                  const BackendChoice& backend) {
  auto const integrator = makeIntegrator(scene, settings, backend);
  if (!integrator->advance(iterations)) throw std::runtime_error("interrupted by nobody");
  if (stats) *stats = integrator->stats();
  return integrator->film();
}

std::vector<BackendChoice> everyBackend() {
  std::vector<BackendChoice> backends{{BackendKind::cpu, 0, 0, false}};
  for (const DeviceInfo& d : listDevices())
    if (d.backend == BackendKind::cuda && d.usable && backends.size() == 1)
      backends.push_back({BackendKind::cuda, d.index, 0, false});
  return backends;
}

double meanOf(const Image& image) {
  double sum = 0;
  for (Rgb p : image.pixels) sum += (double(p.x) + double(p.y) + double(p.z)) / 3;
  return sum / double(image.pixels.size());
}

std::vector<Image> renderSeeds(const Scene& scene, Settings settings, int iterations, int count,
                               const BackendChoice& backend) {
  std::vector<Image> images;
  for (int seed = 1; seed <= count; ++seed) {
    settings.seed = std::uint64_t(seed);
    images.push_back(renderImage(scene, settings, iterations, nullptr, backend));
  }
  return images;
}

TileStatistics tileStatistics(const std::vector<Image>& renderings, int tile) {
  TileStatistics out;
  int const across = (renderings[0].width + tile - 1) / tile, down = (renderings[0].height + tile - 1) / tile;
  std::size_t const tiles = std::size_t(across) * std::size_t(down), n = renderings.size();
  std::vector<std::array<double, 3>> sum(tiles), squares(tiles);
  for (const Image& image : renderings) {
    Image const means = tileMeans(image, tile);
    for (std::size_t t = 0; t < tiles; ++t)
      for (int c = 0; c < 3; ++c) {
        double const m = double(means.pixels[t][c]);
        sum[t][std::size_t(c)] += m;
        squares[t][std::size_t(c)] += m * m;
      }
  }
  out.mean.resize(tiles);
  out.error.resize(tiles);
  for (std::size_t t = 0; t < tiles; ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      double const mean = sum[t][c] / double(n);
      double const variance = n > 1 ? std::max(0.0, squares[t][c] / double(n) - mean * mean) / double(n - 1) : 0.0;
      out.mean[t][c] = mean;
      out.error[t][c] = std::sqrt(variance);
    }
  return out;
}

std::string disagreement(const TileStatistics& a, const TileStatistics& b, double relative) {
  std::string text;
  for (std::size_t t = 0; t < a.mean.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      double const difference = std::abs(a.mean[t][c] - b.mean[t][c]);
      bool const relativelyFar = difference > relative * std::abs(b.mean[t][c]);
      if (relativelyFar && difference > 3 * std::hypot(a.error[t][c], b.error[t][c]))
        text += fmt::format("tile {} channel {}: {:.5f} ± {:.5f} against {:.5f} ± {:.5f}; ", t, c, a.mean[t][c],
                            a.error[t][c], b.mean[t][c], b.error[t][c]);
    }
  return text;
}

}  // namespace ropelight::testing
