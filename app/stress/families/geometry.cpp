// Degenerate, thin, touching, tiny, huge and enclosing surfaces.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/stress/families/closed_forms.h"
#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"

namespace ropelight::families {
namespace {

const char* nameOf(Mode mode) { return mode == Mode::path ? "path" : "sppm"; }

/// Light that gets through a closed wall, as a share of what is on its bright side.
std::vector<Measurement> thinWall(Probe& probe) {
  std::vector<Measurement> out;
  for (double thickness : {1e-1, 1e-3, 1e-5}) {
    Scene scene = emptyScene(0.5f);
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addBox(scene, {-1, -1, -1}, {1, 1, 1});
    addBox(scene, {-thickness / 2, -1.5, -1.5}, {thickness / 2, 1.5, 1.5});
    addSphere(scene, {0.5, 0, 0}, 0.2, black).emission = Emission{Rgb(25), Side::out};
    lookAt(scene, {-0.9, 0.1, 0}, {0, 0, 0}, {0, 1, 0}, 70);  // the wall alone
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 32, 65536);
      settings.radius = 0.05;
      settings.direct = mode == Mode::sppm ? DirectLight::photons : DirectLight::shadow;
      out.push_back({nameOf(mode), thickness, meanOfAll(probe.render(scene, settings, 16).image)});
    }
  }
  return out;
}

/// The floor of a dark room beside a bright one, by photons: discs reach under the wall, and what they find there lies
/// on another floor.
std::vector<Measurement> underWall(Probe& probe) {
  std::vector<Measurement> out;
  double const thickness = 1e-3;
  for (double radius : {0.2, 0.1, 0.05}) {
    Scene scene = boxFurnace(Rgb(0.5f));
    addBox(scene, {-3 - thickness, -1, -1}, {-1 - thickness, 1, 1});
    double const middle = -1 - thickness - 0.2;
    lookAt(scene, {middle, -0.6, 0}, {middle, -1, 0}, {0, 0, 1}, 2 * std::atan(0.5) * 180 / std::numbers::pi);
    Settings settings = probeSettings(Mode::sppm, 32, 65536);
    settings.radius = radius;
    settings.alpha = 1;
    settings.direct = DirectLight::photons;
    Estimate const e = probe.estimate(scene, settings, probe.choose(16, 64), 8, meanOfAll);
    out.push_back({"sppm", radius, e.mean, e.error, 0, 0});
  }
  return out;
}

/// A closed box by photons at a radius that stays: a disc that reaches over an edge is no darker than one that does
/// not.
std::vector<Measurement> edges(Probe& probe) {
  std::vector<Measurement> out;
  for (double radius : {0.4, 0.2, 0.1}) {
    Scene scene = boxFurnace(Rgb(0.5f));
    lookAt(scene, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90);  // the back wall alone, edge to edge
    Settings settings = probeSettings(Mode::sppm, 32, 65536);
    settings.radius = radius;
    settings.alpha = 1;
    settings.direct = DirectLight::photons;
    Estimate const e = probe.estimate(scene, settings, probe.choose(4, 32), 8, meanOfAll);
    out.push_back({"sppm", radius, e.mean, e.error, 2, 0.005});
  }
  return out;
}

/// A closed ball of triangles, with needles, points, copies and planes within it that share its albedo and emission.
std::vector<Measurement> degenerateMesh(Probe& probe) {
  Mesh mesh = sphereMesh(24);
  std::vector<glm::uvec3> const whole = mesh.triangles;
  for (std::size_t i = 0; i < whole.size(); i += 3) mesh.triangles.push_back(whole[i]);  // copies
  for (std::size_t i = 0; i < whole.size(); i += 5) {
    glm::uvec3 const t = whole[i];
    mesh.triangles.emplace_back(t.x, t.x, t.y);
    mesh.triangles.emplace_back(t.x, t.x, t.x);
  }
  Scene scene = emptyScene(0.5f);
  addMesh(scene, mesh);
  int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
  addSphere(scene, {0, 0, 0}, 0.3, black).emission = Emission{Rgb(1), Side::out};
  lookAt(scene, {0, 0.1, 0.7}, {0.5, 0.2, 1}, {0, 1, 0}, 60);
  Scene plain = scene;
  plain.meshes[0] = sphereMesh(24);
  std::vector<Measurement> out;
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Settings settings = probeSettings(mode, 32, 16384);
    std::vector<Image> const a = probe.seeds(scene, settings, 8, 12);
    std::vector<Image> const b = probe.seeds(plain, settings, 8, 12, 1000);
    out.push_back({nameOf(mode), 0, largestZ(a, b, 8, 1e-3), 0, 0, 6});
  }
  return out;
}

/// A closed room in which everything has the albedo 0.5 and emits 0.5, or absorbs nothing: every ray brings 1, whoever
/// stands in whose place.
std::vector<Measurement> samePlace(Probe& probe) {
  std::vector<Measurement> out;
  auto const measure = [&](const char* what, Scene& scene) {
    lookAt(scene, {0.3, 0.1, 0.9}, {0, -0.5, 0}, {0, 1, 0}, 60);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 32, 16384);
      settings.radius = 0.02;
      Estimate const e = probe.estimate(scene, settings, probe.choose(16, 64), 8, meanOfAll);
      out.push_back({fmt::format("{}, {}", what, nameOf(mode)), 0, e.mean, e.error, 1, 0.01});
    }
  };
  Emission const half{Rgb(0.5f), Side::both};
  Scene onFloor = boxFurnace(Rgb(0.5f), 0.5f);
  int const glass = addMaterial(onFloor, DielectricParams{1.5f, Rgb(1), Rgb(1)});
  addBox(onFloor, {-0.4, -1, -0.4}, {0.4, -0.2, 0.4}, glass);
  measure("glass on a floor", onFloor);
  Scene crossing = boxFurnace(Rgb(0.5f), 0.5f);
  addBox(crossing, {-0.4, -1.1, -0.4}, {0.4, -0.2, 0.4}).emission = half;
  addBox(crossing, {-0.6, -0.9, -0.1}, {0.6, -0.4, 0.2}).emission = half;
  addSphere(crossing, {0.1, -0.3, 0}, 0.3).emission = half;
  measure("interpenetrating", crossing);
  Scene twice = boxFurnace(Rgb(0.5f), 0.5f);
  for (int i = 0; i < 3; ++i) addQuad(twice, {-0.5, -0.6, 0.5}, {1, 0, 0}, {0, 0, -1}).emission = half;
  addQuad(twice, {-0.7, -1, 0.7}, {1, 0, 0}, {0, 0, -1}).emission = half;
  measure("copies and coplanar", twice);
  return out;
}

/// A lamp in the plane of a black ceiling, listed before it or after: the irradiance below its middle.
std::vector<Measurement> lampInPlane(Probe& probe) {
  std::vector<Measurement> out;
  double const half = 0.25;
  double const irradiance = integrate(
      [&](double u) {
        return integrate(
            [&](double v) {
              double const x = (2 * u - 1) * half, y = (2 * v - 1) * half, d2 = 1 + x * x + y * y;
              return 4 * half * half / (d2 * d2);
            },
            200);
      },
      200);
  double const expected = 0.5 / std::numbers::pi * irradiance;
  for (bool lampFirst : {true, false}) {
    Scene scene = emptyScene(0.5f);
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    auto const lamp = [&] {
      addQuad(scene, {-half, 1, -half}, {2 * half, 0, 0}, {0, 0, 2 * half}, black).emission =
          Emission{Rgb(1), Side::out};
    };
    if (lampFirst) lamp();
    addQuad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, black);
    if (!lampFirst) lamp();
    lookAt(scene, {0, 0.5, 0.5}, {0, 0, 0}, {0, 1, 0}, 0.5);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e = probe.estimate(scene, probeSettings(mode, 8, 16), 128, 8, meanOfAll);
      out.push_back({fmt::format("lamp listed {}, {}", lampFirst ? "first" : "last", nameOf(mode)), 0,
                     e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// Furnaces inside spheres of every size.
std::vector<Measurement> sphereSizes(Probe& probe) {
  std::vector<Measurement> out;
  for (double radius : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (Mode mode : {Mode::path, Mode::sppm}) {
      if (probe.isShort() && radius != 1e-6 && radius != 1e6) continue;
      Settings settings = probeSettings(mode, 16, 8192);
      settings.radius = 0.3 * radius;
      Estimate const e = probe.estimate(sphereFurnace(Rgb(0.5f), radius), settings, 64, 8, meanOfAll);
      out.push_back({nameOf(mode), radius, e.mean / 2, e.error / 2, 1, 0.005});
    }
  return out;
}

/// The camera where it should not be.
std::vector<Measurement> cameraPlaces(Probe& probe) {
  std::vector<Measurement> out;
  auto const measure = [&](const char* what, const Scene& scene, double expected) {
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 16, 8192);
      settings.radius = 0.1;
      Estimate const e = probe.estimate(scene, settings, 64, 8, meanOfAll);
      out.push_back({fmt::format("{}, {}", what, nameOf(mode)), 0, e.mean / expected, e.error / expected, 1, 0.01});
    }
  };
  Scene onWall = sphereFurnace(Rgb(0.5f), 1);
  lookAt(onWall, {1, 0, 0}, {0, 0.1, 0}, {0, 1, 0}, 40);
  measure("on a surface", onWall, 2);
  Scene inGlass = whiteSurroundings();
  addSphere(inGlass, {0, 0, 0}, 1, addMaterial(inGlass, DielectricParams{1.5f, Rgb(1), Rgb(1)}));
  lookAt(inGlass, {0, 0, 0}, {0.3, 0.1, 1}, {0, 1, 0}, 40);
  measure("inside glass", inGlass, 2.25);  // n²: radiance is denser there
  Scene inLight = emptyScene(0);
  addSphere(inLight, {0, 0, 0}, 1).emission = Emission{Rgb(3), Side::both};
  lookAt(inLight, {0.5, 0, 0}, {0, 0, 1}, {0, 1, 0}, 40);
  measure("inside a light", inLight, 3);
  return out;
}

/// A small lamp far away, ever lower over a floor: E = L π sin²θ cos.
std::vector<Measurement> grazing(Probe& probe) {
  std::vector<Measurement> out;
  for (double rest : {10.0, 1.0, 0.1, 0.01, 0.001}) {
    double const up = rest * std::numbers::pi / 180, radius = 0.2 * std::sin(up);
    double const expected = 0.5 * std::sin(up);  // radiance 1/sin²θ makes π
    Scene scene = emptyScene(0.5f);
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addQuad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    addSphere(scene, {std::cos(up), std::sin(up), 0}, radius, black).emission =
        Emission{Rgb(float(1 / (radius * radius))), Side::out};
    lookAt(scene, {0, 0.5, 0}, {0, 0, 0}, {0, 0, 1}, 0.01 * rest > 0.001 ? 0.01 * rest : 0.001);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e = probe.estimate(scene, probeSettings(mode, 8, 16), 256, 8, meanOfAll);
      out.push_back({nameOf(mode), rest, e.mean / expected, e.error / expected, 1, 0.001});
    }
  }
  return out;
}

}  // namespace

StressFamily geometry() {
  return {"geometry",
          "degenerate, thin, touching, tiny, huge and enclosing surfaces",
          {{"thin wall", "a wall 1e-5 thin between light and darkness", "thickness", "radiance behind it", "0",
            "0: nothing may leak", true, thinWall},
           {"under a wall", "gather discs that reach under a thin wall", "radius / half the room",
            "radiance in the dark", "0: the floor there is another", "0", false, underWall},
           {"edges", "gather discs that reach over edges", "radius / half the room", "radiance on the wall",
            "2 = 1/(1 - albedo)", "0.005", true, edges},
           {"degenerate mesh", "copies, points and segments among the triangles", "", "largest |z| of the tiles",
            "the mesh without them, other seeds", "6 standard errors", true, degenerateMesh},
           {"same place", "glass on a floor, copies, coplanar and interpenetrating surfaces", "", "radiance",
            "1: everything emits 1 - albedo, or absorbs nothing", "1%", true, samePlace},
           {"lamp in a plane", "a lamp in the plane of a ceiling, listed first or last", "", "radiance / closed form",
            "irradiance by quadrature", "1%", true, lampInPlane},
           {"sphere sizes", "rooms of 1e-6 and 1e6", "radius", "radiance / closed form", "1/(1 - albedo)", "0.5%", true,
            sphereSizes},
           {"camera places", "on a surface, inside glass, inside a light", "", "radiance / closed form",
            "1/(1 - albedo), n^2, the light's radiance", "1%", true, cameraPlaces},
           {"grazing light", "a lamp 0.001 degrees above the horizon", "degrees above the horizon",
            "radiance / closed form", "albedo L sin^2 cos", "0.1%", true, grazing}}};
}

}  // namespace ropelight::families
