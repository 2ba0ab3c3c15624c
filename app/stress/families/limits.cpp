// Limits of film and camera.

#include <fmt/format.h>

#include <cmath>

#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"
#include "render/film/tonemap.h"

namespace ropelight::families {
namespace {

std::vector<Measurement> filmSizes(Probe& probe) {
  std::vector<Measurement> out;
  std::vector<std::pair<int, int>> sizes{{1, 1}, {16384, 1}, {1, 16384}, {16384, 16}};
  if (probe.isGpu() && !probe.isShort()) sizes.emplace_back(16384, 16384);
  for (auto const& [width, height] : sizes)
    for (Mode mode : {Mode::path, Mode::sppm}) {
      if (mode == Mode::sppm && double(width) * height > 1e7) continue;  // the film is what is tested
      bool const small = double(width) * height < 100;
      Settings settings = probeSettings(mode, 1, small ? 4096 : std::uint64_t(probe.choose(16384, 65536)));
      settings.width = width;
      settings.height = height;
      settings.radius = small ? 0.1 : 0.3;
      Estimate const e =
          probe.estimate(sphereFurnace(Rgb(0.5f), 1), settings, small ? 512 : 1, height > 1 ? 4 : 8, meanOfAll);
      // 1 is seen, 0.5 is direct light by shadow rays, 0.5 is gathered.
      double const expected = mode == Mode::path ? 2 : 1.5 + 0.5 * (small ? 1 : discGain(settings.radius));
      out.push_back({fmt::format("{} x {}, {}", width, height, mode == Mode::path ? "path" : "sppm"),
                     double(width) * height, e.mean / expected, e.error / expected, 1,
                     mode == Mode::path ? 0.01 : 0.02});
    }
  return out;
}

std::vector<Measurement> fields(Probe& probe) {
  std::vector<Measurement> out;
  for (double fov : {1e-3, 1.0, 90.0, 179.0, 179.9})
    for (Mode mode : {Mode::path, Mode::sppm}) {
      Scene scene = sphereFurnace(Rgb(0.5f), 1);
      scene.camera.verticalFov = fov;
      Settings settings = probeSettings(mode, 16, 8192);
      settings.radius = 0.1;
      Estimate const e = probe.estimate(scene, settings, probe.choose(32, 64), 8, meanOfAll);
      out.push_back({mode == Mode::path ? "path" : "sppm", fov, e.mean / 2, e.error / 2, 1, 0.01});
    }
  return out;
}

/// Radiance 2^−e at the exposure e gives the bytes of radiance 1.
std::vector<Measurement> exposures(Probe&) {
  std::vector<Measurement> out;
  for (ToneCurve curve : {ToneCurve::linear, ToneCurve::reinhard, ToneCurve::aces}) {
    Image plain(16, 1);
    for (int x = 0; x < 16; ++x) plain.at(x, 0) = Rgb(float(x) / 15, 0.5f, 0.1f);
    ScreenImage const expected = toScreen(plain, {curve, 0});
    for (double stops : {-100.0, -60.0, -10.0, 10.0, 60.0, 100.0}) {
      Image image = plain;
      for (Rgb& p : image.pixels) p *= float(std::exp2(-stops));
      ScreenImage const screen = toScreen(image, {curve, stops});
      double largest = double(screen.nonFinite);
      for (std::size_t i = 0; i < screen.bytes.size(); ++i)
        largest = std::max(largest, std::abs(double(screen.bytes[i]) - double(expected.bytes[i])));
      out.push_back({toneCurveNames()[std::size_t(curve)], stops, largest});
    }
  }
  return out;
}

}  // namespace

StressFamily limits() {
  return {"limits",
          "of film and camera",
          {{"film sizes", "one pixel, one row, 16,384 squared on a GPU", "pixels", "radiance / closed form",
            "1/(1 - albedo), with what discs gain on a sphere", "1%; sppm 2%", false, filmSizes},
           {"fields of view", "0.001 and 179.9 degrees", "degrees", "radiance / closed form", "1/(1 - albedo)", "1%",
            true, fields},
           {"exposures", "100 stops up and down", "stops", "largest difference of bytes", "the bytes at exposure 0",
            "0", true, exposures}}};
}

}  // namespace ropelight::families
