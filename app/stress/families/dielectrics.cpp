// Glass of every index, at every angle, nested, touching, in facets.

#include <fmt/format.h>

#include "app/stress/families/closed_forms.h"
#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"

namespace ropelight::families {
namespace {

DielectricParams glassOf(double index) { return DielectricParams{float(index), Rgb(1), Rgb(1)}; }

/// A pane of glass between a lamp and a floor in a cell of perfect mirrors: endless planes.
Scene paneOverFloor(double index, float albedo) {
  Scene scene = mirrorCell(albedo);
  addBox(scene, {-1.5, 1, -1.5}, {1.5, 1.2, 1.5}, addMaterial(scene, glassOf(index)));
  return scene;
}

std::vector<Measurement> pane(Probe& probe) {
  std::vector<Measurement> out;
  for (double index : {0.5, 1.0, 1.0001, 1.5, 2.4, 10.0}) {
    if (probe.isShort() && index != 1.0001 && index != 2.4) continue;
    double const albedo = 0.5, through = diffusePlateTransmittance(double(float(index)));
    double const expected = albedo * through / (1 - albedo * (1 - through));
    Scene const scene = paneOverFloor(index, float(albedo));
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 16, 16384);
      settings.radius = 0.1;
      Estimate const e =
          probe.estimate(scene, settings, probe.choose(1, 2) * (mode == Mode::path ? 256 : 16), 8, meanOfAll);
      out.push_back({mode == Mode::path ? "path" : "sppm", index, e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// A pane seen at an angle, with a lamp that fills everything behind it.
Scene paneAtAngle(double radians, double fov) {
  Scene scene = emptyScene(0);
  double const thickness = std::min(1.0, 100 * radians), wide = 4 / radians;
  addBox(scene, {-wide, -thickness, -wide}, {wide, 0, wide}, addMaterial(scene, glassOf(1.5)));
  addQuad(scene, {-wide, -1.5 * thickness, wide}, {2 * wide, 0, 0}, {0, 0, -2 * wide}).emission =
      Emission{Rgb(1), Side::both};
  lookAt(scene, {0, std::sin(radians), 0}, {std::cos(radians), 0, 0}, {0, 0, 1}, fov);
  return scene;
}

/// What passes the pane, as far as a direction of floats can say at which angle it leaves: inside the glass one
/// rounding is 1e-7 of the square of that angle's sine. Nearer to grazing, that nothing is lost: the surroundings
/// are 1.
std::vector<Measurement> angle(Probe& probe) {
  std::vector<Measurement> out;
  for (double rest : {60.0, 10.0, 1.0, 0.3, 1e-2, 1e-4}) {
    double const radians = rest * std::numbers::pi / 180, fov = std::max(rest * 1e-3, 0.001);
    if (rest < 0.1) {
      Scene scene = whiteSurroundings(4);
      addBox(scene, {-3, -0.1, -3}, {3, 0, 3}, addMaterial(scene, glassOf(1.5)));
      lookAt(scene, {0, std::sin(radians), 0}, {std::cos(radians), 0, 0}, {0, 0, 1}, fov);
      Estimate const e = probe.estimate(scene, probeSettings(Mode::path, 8, 1), 64, 8, meanOfAll);
      out.push_back({"path, all that is reflected or passes", rest, e.mean, e.error, 1, 0.003});
      continue;
    }
    double const expected = plateTransmittance(std::sin(radians), 1.5);
    Estimate const e = probe.estimate(paneAtAngle(radians, fov), probeSettings(Mode::path, 8, 1), 2048, 16, meanOfAll);
    // Even a narrow view spans angles: what they differ by belongs to the bound.
    double const half = 0.5 * fov * std::numbers::pi / 180;
    double const spread = std::abs(plateTransmittance(std::sin(radians + half), 1.5) -
                                   plateTransmittance(std::sin(radians - half), 1.5)) /
                          expected;
    out.push_back({"path, what passes", rest, e.mean / expected, e.error / expected, 1, 0.02 + spread});
  }
  return out;
}

/// Looking out of glass through its flat face near the critical angle. What is reflected meets a lamp in the glass
/// whose radiance is that of the surroundings there, n²: every ray brings n², however it is divided.
std::vector<Measurement> criticalAngle(Probe& probe) {
  std::vector<Measurement> out;
  double const index = 1.5, critical = std::asin(1 / index);
  for (double off : {-1e-2, -1e-4, -1e-6, 0.0, 1e-6, 1e-4, 1e-2}) {
    Scene scene = whiteSurroundings(50);
    addBox(scene, {-5, -5, -5}, {5, 0, 5}, addMaterial(scene, glassOf(index)));
    addQuad(scene, {-4.9, -3, 4.9}, {9.8, 0, 0}, {0, 0, -9.8}).emission =
        Emission{Rgb(float(index * index)), Side::out};
    double const a = critical + off;
    lookAt(scene, {0, -std::cos(a), 0}, {std::sin(a), 0, 0}, {0, 0, 1}, 0.001);
    Estimate const e = probe.estimate(scene, probeSettings(Mode::path, 8, 1), 256, 8, meanOfAll);
    out.push_back({"path", off, e.mean / (index * index), e.error / (index * index), 1, 0.01});
  }
  return out;
}

/// Lossless things in white surroundings: every ray of every camera outside brings 1.
std::vector<Measurement> whiteWorld(Probe& probe) {
  std::vector<Measurement> out;
  auto const measure = [&](const char* what, double parameter, Scene scene) {
    lookAt(scene, {0.3, 0.2, 3}, {0, 0, 0}, {0, 1, 0}, 40);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e = probe.estimate(scene, probeSettings(mode, 32, 1), probe.choose(32, 128), 8, meanOfAll);
      out.push_back({fmt::format("{}, {}", what, mode == Mode::path ? "path" : "sppm"), parameter, e.mean, e.error, 1,
                     parameter == 10 ? 0.02 : 0.003});
    }
  };
  for (double index : {0.5, 1.0, 1.0001, 1.5, 2.4, 10.0}) {
    Scene sphere = whiteSurroundings();
    addSphere(sphere, {0, 0, 0}, 1, addMaterial(sphere, glassOf(index)));
    measure("sphere", index, sphere);
    if (probe.isShort()) continue;
    Scene box = whiteSurroundings();
    addBox(box, {-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7}, addMaterial(box, glassOf(index)));
    measure("box", index, box);
    Scene facets = whiteSurroundings();
    addMesh(facets, sphereMesh(12), addMaterial(facets, glassOf(index)));
    measure("facets", index, facets);
  }
  Scene nested = whiteSurroundings();
  int const glass = addMaterial(nested, glassOf(1.5)), denser = addMaterial(nested, glassOf(1.2));
  addSphere(nested, {0, 0, 0}, 1, glass);
  addSphere(nested, {0.1, 0, 0}, 0.6, denser);
  addSphere(nested, {0.1, 0.1, 0}, 0.3, glass);
  measure("nested", 1.5, nested);
  Scene touching = whiteSurroundings();
  int const left = addMaterial(touching, glassOf(1.5)), right = addMaterial(touching, glassOf(1.33));
  addBox(touching, {-0.7, -0.7, -0.7}, {0, 0.7, 0.7}, left);
  addBox(touching, {0, -0.7, -0.7}, {0.7, 0.7, 0.7}, right);
  measure("touching", 1.5, touching);
  return out;
}

}  // namespace

StressFamily dielectrics() {
  return {"dielectrics",
          "glass of every index, at every angle, nested, touching, in facets",
          {{"pane", "light of all directions through glass of an extreme index", "index of refraction",
            "radiance / closed form", "endless parallel planes, Fresnel by quadrature", "1%", true, pane},
           {"grazing pane", "a pane seen from 1e-4 degrees above its plane", "degrees above the plane",
            "radiance / closed form", "(1 - R)/(1 + R); below 0.1 degrees 1, that nothing is lost",
            "2%, and what the view's angles differ by; 0.3%", true, angle},
           {"critical angle", "rays from within glass where total reflection begins", "radians off the critical angle",
            "radiance / n^2", "n^2: in the glass as around it", "1%", true, criticalAngle},
           {"white world", "spheres, boxes, facets, nested and touching glass of every index", "index of refraction",
            "radiance", "1: nothing absorbs, and the surroundings are 1",
            "0.3%; at an index of 10, where light is caught for long, 2%", true, whiteWorld}}};
}

}  // namespace ropelight::families
