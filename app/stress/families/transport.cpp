// Stiff transport: light that bounces often, comes from little or hidden places, or differs by many powers of ten.

#include <fmt/format.h>

#include "app/stress/families/closed_forms.h"
#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"

namespace ropelight::families {
namespace {

const char* nameOfMode(Mode mode) { return mode == Mode::path ? "path" : "sppm"; }

/// Iterations that make paths of 1/(1 − albedo) bounces cost alike.
std::vector<Measurement> furnaces(Probe& probe) {
  std::vector<Measurement> out;
  std::vector<float> albedos{0.9f, 0.99f};
  if (!probe.isShort()) albedos.insert(albedos.end(), {0.999f, 0.9999f});
  for (float albedo : albedos)
    for (Mode mode : {Mode::path, Mode::sppm}) {
      double const expected = 1 / (1 - double(albedo));
      Scene const scene = sphereFurnace(Rgb(albedo), 1);
      Settings settings = probeSettings(mode, 16, 1024);
      settings.radius = 0.1;
      bool const stiffest = expected > 5000;
      int const iterations = stiffest ? 16 : std::max(8, int(probe.choose(320, 640) / std::sqrt(expected)));
      Estimate const e = probe.estimate(scene, settings, iterations, 8, meanOfAll);
      out.push_back({nameOfMode(mode), expected, e.mean / expected, e.error / expected, 1, stiffest ? 0.02 : 0.01});
    }
  return out;
}

/// The same with a ball of glass in it, through which paths are refracted both ways: it absorbs nothing.
std::vector<Measurement> furnaceWithGlass(Probe& probe) {
  std::vector<Measurement> out;
  for (float albedo : {0.5f, 0.9f, 0.99f}) {
    if (probe.isShort() && albedo > 0.9f) continue;
    double const expected = 1 / (1 - double(albedo));
    Scene scene = sphereFurnace(Rgb(albedo), 1);
    addSphere(scene, {-0.2, 0.1, -0.4}, 0.3, addMaterial(scene, DielectricParams{1.5f, Rgb(1), Rgb(1)}));
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 16, 1024);
      settings.radius = 0.1;
      Estimate const e = probe.estimate(scene, settings, probe.choose(128, 256), 8, meanOfAll);
      out.push_back({nameOfMode(mode), expected, e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// Every channel's own series, since roulette looks at the brightest alone.
std::vector<Measurement> colouredFurnace(Probe& probe) {
  std::vector<Measurement> out;
  Rgb const albedo(0.95f, 0.5f, 0.05f);
  Scene const scene = sphereFurnace(albedo, 1);
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Settings settings = probeSettings(mode, 16, 1024);
    settings.radius = 0.1;
    for (int c = 0; c < 3; ++c) {
      double const expected = 1 / (1 - double(albedo[c]));
      Estimate const e = probe.estimate(scene, settings, probe.choose(32, 64), 8,
                                        [&](const Image& image) { return meanOfChannel(image, c); });
      out.push_back({fmt::format("{}, channel {}", nameOfMode(mode), c), double(c), e.mean / expected,
                     e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// A ray at 45° in a slot between two mirrors 1 apart: it hits them `bounces` times, then the lamp at the end.
Scene mirrorSlot(Rgb reflectance, int bounces) {
  Scene scene = emptyScene(0);
  int const mirror = addMaterial(scene, MirrorParams{reflectance});
  double const length = bounces;  // the ray begins in the middle and advances by 1 a bounce
  addQuad(scene, {-1, -0.5, -1}, {length + 1, 0, 0}, {0, 0, 2}, mirror);
  addQuad(scene, {-1, 0.5, -1}, {length + 1, 0, 0}, {0, 0, 2}, mirror);
  addQuad(scene, {length, -0.5, -1}, {0, 1, 0}, {0, 0, 2}).emission = Emission{Rgb(1), Side::both};
  lookAt(scene, {0, 0, 0}, {1, 1, 0}, {0, 0, 1}, 0.002);
  return scene;
}

std::vector<Measurement> colouredProduct(Probe& probe) {
  std::vector<Measurement> out;
  Rgb const reflectance(1.0f, std::pow(10.0f, -0.8f), 0.5f);
  Scene const scene = mirrorSlot(reflectance, 10);
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Settings const settings = probeSettings(mode, 8, 1);
    for (int c = 0; c < 3; ++c) {
      double const expected = std::pow(double(reflectance[c]), 10);
      Estimate const e =
          probe.estimate(scene, settings, 256, 8, [&](const Image& image) { return meanOfChannel(image, c); });
      out.push_back({fmt::format("{}, channel {}", nameOfMode(mode), c), expected, e.mean / expected,
                     e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// Wide mirrors that face one another and emit 1: Σρᵏ.
std::vector<Measurement> facingMirrors(Probe& probe) {
  std::vector<Measurement> out;
  for (float rho : {0.5f, 0.9f, 0.99f, 0.999f}) {
    if (probe.isShort() && rho > 0.99f) continue;
    Scene scene = emptyScene(0);
    int const mirror = addMaterial(scene, MirrorParams{Rgb(rho)});
    addQuad(scene, {-1e5, -1e5, 1}, {0, 2e5, 0}, {2e5, 0, 0}, mirror).emission = Emission{Rgb(1), Side::out};
    addQuad(scene, {-1e5, -1e5, -1}, {2e5, 0, 0}, {0, 2e5, 0}, mirror).emission = Emission{Rgb(1), Side::out};
    lookAt(scene, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40);
    double const expected = 1 / (1 - double(rho));
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e = probe.estimate(scene, probeSettings(mode, 16, 1), rho > 0.99f ? 4096 : 64, 8, meanOfAll);
      out.push_back({nameOfMode(mode), expected, e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// A rod of glass 1 wide; what is seen through it at 45° has been reflected inside it by its length · tan θ' times.
std::vector<Measurement> lightPipe(Probe& probe) {
  std::vector<Measurement> out;
  double const index = 1.5, angle = std::numbers::pi / 4;
  double const inside = std::asin(std::sin(angle) / index), expected = plateTransmittance(std::cos(angle), index);
  for (double bounces : {10.0, 100.0, 1000.0}) {
    if (probe.isShort() && bounces > 100) continue;
    double const length = bounces / std::tan(inside);
    Scene scene = emptyScene(0);
    int const glass = addMaterial(scene, DielectricParams{float(index), Rgb(1), Rgb(1)});
    addBox(scene, {0, -0.5, -0.5}, {length, 0.5, 0.5}, glass);
    addQuad(scene, {length + 1, -50, -50}, {0, 0, 100}, {0, 100, 0}).emission = Emission{Rgb(1), Side::both};
    lookAt(scene, {-1, 1.03, 0.01}, {0, 0.03, 0.01}, {0, 0, 1}, 0.5);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e =
          probe.estimate(scene, probeSettings(mode, 8, 1), bounces > 100 ? 2048 : 512, probe.choose(8, 16), meanOfAll);
      out.push_back({nameOfMode(mode), bounces, e.mean / expected, e.error / expected, 1, 0.02});
    }
  }
  return out;
}

/// A sphere lamp of radius r at the height 1 above a floor: E = L π sin²θ.
std::vector<Measurement> smallLight(Probe& probe) {
  std::vector<Measurement> out;
  for (double r : {1e-1, 1e-3, 1e-5, 1e-6}) {
    double const albedo = 0.5, sine2 = r * r, expected = albedo;  // radiance 1/sin²θ makes E = π
    Scene scene = emptyScene(float(albedo));
    addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addSphere(scene, {0, 1, 0}, r, black).emission = Emission{Rgb(float(1 / sine2)), Side::out};
    lookAt(scene, {0, 0.5, 0.5}, {0, 0, 0}, {0, 1, 0}, 0.1);
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 8, 16);
      Estimate const e = probe.estimate(scene, settings, 256, 8, meanOfAll);
      out.push_back({nameOfMode(mode), r, e.mean / expected, e.error / expected, 1, 0.001});
    }
    if (probe.isShort()) continue;
    Settings byPhotons = probeSettings(Mode::sppm, 8, 65536);
    byPhotons.direct = DirectLight::photons;
    byPhotons.radius = 0.1;
    byPhotons.alpha = 1;  // E over the disc: (1/0.01)·∫ cos⁴ …, within 0.5% of its centre
    Estimate const e = probe.estimate(scene, byPhotons, 32, 8, meanOfAll);
    out.push_back({"sppm, direct light by photons", r, e.mean / expected, e.error / expected, 1, 0.012});
  }
  return out;
}

/// A closed dark box with a hole of side h in its lid, under a bright ceiling; the floor's patch opposite the hole.
std::vector<Measurement> pinhole(Probe& probe) {
  std::vector<Measurement> out;
  for (double h : {0.3, 0.1, 0.03}) {
    if (probe.isShort() && h < 0.1) continue;
    Scene scene = emptyScene(0);
    int const white = addMaterial(scene, DiffuseParams{Rgb(0.5f)});
    addQuad(scene, {-0.02, 0, 0.02}, {0.04, 0, 0}, {0, 0, -0.04}, white);
    double const a = h / 2;
    for (double side : {-1.0, 1.0}) {
      double const low = side < 0 ? -3 : a;
      addQuad(scene, {low, 1, 3}, {3 - a, 0, 0}, {0, 0, -6});
      addQuad(scene, {-a, 1, low + 3 - a}, {h, 0, 0}, {0, 0, -(3 - a)});
    }
    // The lamp lies close above, and fills the hole as seen from the patch.
    addQuad(scene, {-1.2 * a, 1.01, -1.2 * a}, {2.4 * a, 0, 0}, {0, 0, 2.4 * a}).emission =
        Emission{Rgb(float(1 / (h * h))), Side::out};
    lookAt(scene, {0.2, 0.3, 0}, {0, 0, 0}, {0, 0, 1}, 1);
    double const irradiance = integrate(
        [&](double u) {
          return integrate(
              [&](double v) {
                double const x = (u - 0.5) * h, y = (v - 0.5) * h, d2 = 1 + x * x + y * y;
                return 1 / (d2 * d2);
              },
              200);
        },
        200);
    double const expected = 0.5 / std::numbers::pi * irradiance;
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Estimate const e = probe.estimate(scene, probeSettings(mode, 16, 256), probe.choose(64, 256), 8, meanOfAll);
      out.push_back({nameOfMode(mode), h, e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// Two lamps in two cells that see nothing of one another.
std::vector<Measurement> radianceRatio(Probe& probe) {
  std::vector<Measurement> out;
  for (double ratio : {1e3, 1e6, 1e12}) {
    Scene scene = emptyScene(0.5f);
    int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
    addQuad(scene, {-4, 0, 4}, {8, 0, 0}, {0, 0, -8});
    addQuad(scene, {0, 0, 4}, {0, 8, 0}, {0, 0, -8}, black);
    addSphere(scene, {-1, 1, 0}, 0.1, black).emission = Emission{Rgb(float(ratio)), Side::out};
    addSphere(scene, {1, 1, 0}, 0.1, black).emission = Emission{Rgb(1), Side::out};
    lookAt(scene, {-1, 0.5, 0.5}, {-1, 0, 0}, {0, 1, 0}, 0.1);
    double const expected = 0.5 * 0.01 * ratio;
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Settings settings = probeSettings(mode, 8, 16);
      settings.maxDepth = 2;
      Estimate const e = probe.estimate(scene, settings, 256, 8, meanOfAll);
      out.push_back({nameOfMode(mode), ratio, e.mean / expected, e.error / expected, 1, 0.01});
    }
  }
  return out;
}

/// A lamp over a floor, two panes between them, in a cell of perfect mirrors: an endless plane of each.
std::vector<Measurement> behindGlass(Probe& probe) {
  double const albedo = 0.5, through = diffusePlateTransmittance(1.5, 4);
  double const expected = albedo * through / (1 - albedo * (1 - through));
  Scene scene = mirrorCell(float(albedo));
  int const glass = addMaterial(scene, DielectricParams{1.5f, Rgb(1), Rgb(1)});
  for (double y : {1.0, 1.4}) addBox(scene, {-1.5, y, -1.5}, {1.5, y + 0.1, 1.5}, glass);
  std::vector<Measurement> out;
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Settings settings = probeSettings(mode, 16, 16384);
    settings.radius = 0.1;
    Estimate const e =
        probe.estimate(scene, settings, probe.choose(1, 2) * (mode == Mode::path ? 256 : 16), 8, meanOfAll);
    out.push_back({nameOfMode(mode), 4, e.mean / expected, e.error / expected, 1, 0.01});
  }
  return out;
}

}  // namespace

StressFamily transport() {
  return {"transport",
          "light that bounces often, comes from small or hidden places, or differs by many powers of ten",
          {{"furnace", "a closed room whose paths have up to thousands of bounces", "mean bounces 1/(1 - albedo)",
            "radiance / closed form", "1/(1 - albedo)", "1%, 2% at 0.9999: roulette and depth limits must not bias",
            true, furnaces},
           {"furnace with glass", "the same with refraction both ways in it", "mean bounces 1/(1 - albedo)",
            "radiance / closed form", "1/(1 - albedo): glass absorbs nothing", "1%", true, furnaceWithGlass},
           {"coloured furnace", "roulette looks at the brightest channel alone", "channel", "radiance / closed form",
            "1/(1 - albedo) of each channel", "1%", true, colouredFurnace},
           {"coloured product", "ten bounces leave 1e-8 of one channel", "what is left of the channel",
            "radiance / closed form", "reflectance to the tenth power", "1%", true, colouredProduct},
           {"facing mirrors", "specular chains of hundreds of bounces that emit on the way", "mean bounces 1/(1 - rho)",
            "radiance / closed form", "1/(1 - rho)", "1%", true, facingMirrors},
           {"light pipe", "total internal reflection, without loss, up to 1000 times", "reflections",
            "radiance / closed form", "(1 - R)/(1 + R) of the two ends", "2%: none may be lost on the way", true,
            lightPipe},
           {"small light", "a lamp 1e-6 of its distance", "radius / distance", "radiance / closed form",
            "albedo L sin^2", "0.1%; 1.2% by photons, whose disc is 0.1 wide", true, smallLight},
           {"pinhole", "a room lit through a hole", "side of the hole / distance", "radiance / closed form",
            "the hole's irradiance by quadrature", "1%", true, pinhole},
           {"radiance ratio", "a light 1e12 times as bright as the other", "ratio", "radiance / closed form",
            "albedo L sin^2 of the bright one", "1%: pixels that it lights are judged", true, radianceRatio},
           {"behind glass", "a lamp behind two panes, which no shadow ray sees through", "interfaces",
            "radiance / closed form", "endless parallel planes, Fresnel by quadrature", "1%", false, behindGlass}}};
}

}  // namespace ropelight::families
