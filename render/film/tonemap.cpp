#include "render/film/tonemap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"

namespace ropelight {
namespace {

double acesFit(double x) { return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14); }

/// Non-negative scene-linear to screen-linear; in double, so that a bright pixel at high exposure stays finite.
Vec3d applyCurve(ToneCurve curve, Vec3d c) {
  switch (curve) {
    case ToneCurve::linear:
      break;
    case ToneCurve::reinhard:
      return c / (1.0 + glm::dot(c, Vec3d(0.2126, 0.7152, 0.0722)));
    case ToneCurve::aces:
      return Vec3d(acesFit(c.x), acesFit(c.y), acesFit(c.z));
  }
  return c;
}

std::uint8_t quantise(double linear) {
  return std::uint8_t(std::floor(255.0 * encodeSrgb(std::clamp(linear, 0.0, 1.0)) + 0.5));
}

double exposureFactor(double stops) {
  if (!(std::abs(stops) <= 100.0))
    throw Error(fmt::format("exposure: {} is not a number of stops from -100 to 100; give one", stops),
                ExitCode::usage);
  return std::exp2(stops);
}

}  // namespace

const std::vector<std::string>& toneCurveNames() {
  static const std::vector<std::string> names = {"linear", "reinhard", "aces"};
  return names;
}

ToneCurve toneCurveFromName(const std::string& name) {
  const auto& names = toneCurveNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(fmt::format("tone curve '{}': expected {}; name one of them", name, fmt::join(names, ", ")),
                ExitCode::usage);
  return ToneCurve(found - names.begin());
}

double encodeSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void checkTonemap(const Tonemap& tonemap) { exposureFactor(tonemap.exposure); }

std::uint64_t toScreen(std::span<const Rgb> pixels, const Tonemap& tonemap, std::uint8_t* out) {
  const double factor = exposureFactor(tonemap.exposure);
  std::uint64_t nonFinite = 0;
  for (Rgb pixel : pixels) {
    const bool usable = isFinitePixel(pixel);
    if (!usable) ++nonFinite;
    const Vec3d radiance = usable ? glm::max(Vec3d(pixel), Vec3d(0.0)) : Vec3d(0.0);
    const Vec3d shown = applyCurve(tonemap.curve, radiance * factor);
    for (int channel = 0; channel < 3; ++channel) *out++ = quantise(shown[channel]);
  }
  return nonFinite;
}

ScreenImage toScreen(const Image& image, const Tonemap& tonemap) {
  ScreenImage screen;
  screen.bytes.resize(image.pixels.size() * 3);
  screen.nonFinite = toScreen(image.pixels, tonemap, screen.bytes.data());
  return screen;
}

}  // namespace ropelight
