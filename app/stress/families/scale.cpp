// The same scene at another size, at another place, or squeezed.

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"

namespace ropelight::families {
namespace {

/// Every shape's transform and the camera, by x ↦ scale·x + offset.
Scene placed(Scene scene, double scale, Vec3d offset) {
  glm::dmat4 m(scale);
  m[3] = glm::dvec4(offset, 1);
  for (ShapeDesc& shape : scene.shapes) shape.toWorld = m * shape.toWorld;
  scene.camera.position = scale * scene.camera.position + offset;
  scene.camera.target = scale * scene.camera.target + offset;
  return scene;
}

double differentPixels(const Image& a, const Image& b) {
  double count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(Rgb)) != 0;
  return count;
}

Settings roomSettings(Mode mode) {
  Settings settings = probeSettings(mode, 32, 8192);
  return settings;
}

std::vector<Measurement> powersOfTwo(Probe& probe) {
  std::vector<Measurement> out;
  Scene const scene = mixedRoom();
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Image const expected = probe.render(scene, roomSettings(mode), 4).image;
    for (int exponent : {-20, -10, 10, 20}) {
      Image const image = probe.render(placed(scene, std::ldexp(1.0, exponent), Vec3d(0)), roomSettings(mode), 4).image;
      out.push_back({mode == Mode::path ? "path" : "sppm", double(exponent), differentPixels(image, expected)});
    }
  }
  return out;
}

std::vector<Measurement> againstPlain(Probe& probe, const std::vector<std::pair<double, Scene>>& others) {
  std::vector<Measurement> out;
  int const count = 12;
  for (Mode mode : {Mode::path, Mode::sppm}) {
    std::vector<Image> const expected = probe.seeds(mixedRoom(), roomSettings(mode), probe.choose(4, 16), count);
    for (const auto& [parameter, scene] : others) {
      std::vector<Image> const images = probe.seeds(scene, roomSettings(mode), probe.choose(4, 16), count, 1000);
      // 48 tiles and channels of 12 + 12 renderings: a difference of 6 standard errors is not chance (t of 22 degrees).
      out.push_back({mode == Mode::path ? "path" : "sppm", parameter, largestZ(images, expected, 8, 1e-3), 0, 0, 6});
    }
  }
  return out;
}

std::vector<Measurement> powersOfTen(Probe& probe) {
  std::vector<std::pair<double, Scene>> others;
  for (int exponent : {-6, -3, 3, 6})
    others.emplace_back(exponent, placed(mixedRoom(), std::pow(10, exponent), Vec3d(0)));
  return againstPlain(probe, others);
}

std::vector<Measurement> moved(Probe& probe) {
  std::vector<std::pair<double, Scene>> others;
  for (double distance : {1e2, 1e4, 1e6})
    others.emplace_back(distance, placed(mixedRoom(), 1, Vec3d(distance, -0.7 * distance, 0.3 * distance)));
  return againstPlain(probe, others);
}

/// A closed sphere of triangles whose own vertices lie far from the origin, rounded to what a float can say there.
std::vector<Measurement> farVertices(Probe& probe) {
  std::vector<Measurement> out;
  for (double distance : {1e3, 1e5, 1e6}) {
    Vec3d const center(distance, -0.7 * distance, 0.3 * distance);
    Mesh mesh = sphereMesh(16);
    for (Vec3d& p : mesh.positions) p = Vec3d(glm::vec3(4.0 * p + center));
    Scene scene = emptyScene(0.5f);
    addMesh(scene, mesh).emission = std::nullopt;
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addSphere(scene, center, 1, black).emission = Emission{Rgb(1), Side::out};
    lookAt(scene, center + Vec3d(0, 0.5, 2.5), center + Vec3d(0, 3, 3), {0, 0, 1}, 50);
    Scene plain = scene;  // the same vertices, moved to the origin in double
    for (Vec3d& p : plain.meshes[0].positions) p -= center;
    plain.shapes[1].toWorld[3] = glm::dvec4(0, 0, 0, 1);
    plain.camera = ropelight::moved(plain.camera, -center);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      std::vector<Image> const expected = probe.seeds(plain, roomSettings(mode), 4, 12);
      std::vector<Image> const images = probe.seeds(scene, roomSettings(mode), 4, 12, 1000);
      out.push_back({mode == Mode::path ? "path" : "sppm", distance, largestZ(images, expected, 8, 1e-3), 0, 0, 6});
    }
  }
  return out;
}

/// Closed rooms squeezed: every ray still brings 1/(1 − albedo).
std::vector<Measurement> anisotropic(Probe& probe) {
  std::vector<Measurement> out;
  for (double aspect : {10.0, 1e2, 1e3, 1e4}) {
    glm::dmat4 squeeze(1.0);
    squeeze[0][0] = aspect;
    for (bool box : {true, false}) {
      Scene scene = box ? boxFurnace(Rgb(0.5f)) : sphereFurnace(Rgb(0.5f), 1);
      for (ShapeDesc& shape : scene.shapes) shape.toWorld = squeeze * shape.toWorld;
      lookAt(scene, {0.1, 0.2, 0.3}, {0.2, -0.3, -1}, {0, 1, 0}, 60);
      Estimate const e = probe.estimate(scene, probeSettings(Mode::path, 16, 1), 64, 8, meanOfAll);
      out.push_back({box ? "box, path" : "ellipsoid, path", aspect, e.mean / 2, e.error / 2, 1, 0.005});
    }
  }
  return out;
}

}  // namespace

StressFamily scale() {
  return {"scale",
          "the same scene at another size, at another place, or squeezed",
          {{"powers of two", "scaled by 2^20: no rounding may differ", "exponent", "pixels with other bits",
            "the film of the scene itself, same seed", "0: products with powers of two are exact", true, powersOfTwo},
           {"powers of ten", "millimetres or thousands of kilometres", "exponent", "largest |z| of the tiles",
            "the scene itself, other seeds", "6 standard errors over 48 tiles and channels", true, powersOfTen},
           {"moved", "moved a million units away by its transforms", "distance, scene units",
            "largest |z| of the tiles", "the scene itself, other seeds", "6 standard errors", true, moved},
           {"far vertices", "a file's own vertices a million units away, where floats are 1/16 apart",
            "distance, scene units", "largest |z| of the tiles", "the same rounded vertices, moved back in double",
            "6 standard errors", false, farVertices},
           {"squeezed", "rooms 1e4 times as long as wide", "aspect", "radiance / closed form", "1/(1 - albedo)", "0.5%",
            true, anisotropic}}};
}

}  // namespace ropelight::families
