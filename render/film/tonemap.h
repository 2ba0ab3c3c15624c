#pragma once
// From linear radiance to the 8-bit sRGB of a screen: exposure, tone curve, transfer function, rounding.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/film/image.h"

namespace ropelight {

enum class ToneCurve {
  linear,    ///< clamped to [0, 1]
  reinhard,  ///< L/(1 + L) on luminance (Reinhard et al. 2002, eq. 3), hue kept
  aces,      ///< fit to the ACES filmic curve, by channel (Narkowicz 2015, "ACES filmic tone mapping curve")
};

/// The curves' names in menu order.
const std::vector<std::string>& toneCurveNames();
/// Throws Error (usage) for a name that is none of toneCurveNames().
ToneCurve toneCurveFromName(const std::string& name);

struct Tonemap {
  ToneCurve curve = ToneCurve::linear;
  double exposure = 0;  ///< stops (EV): radiance is multiplied by 2^exposure; within ±100
};

/// The sRGB transfer function and its inverse (IEC 61966-2-1), [0, 1] → [0, 1].
double encodeSrgb(double linear);
double decodeSrgb(double encoded);

struct ScreenImage {
  std::vector<std::uint8_t> bytes;  ///< width·height·3, row 0 at the top
  std::uint64_t nonFinite = 0;      ///< pixels with a NaN or an infinity, shown black
};

/// Throws Error (usage) for an exposure outside ±100.
void checkTonemap(const Tonemap& tonemap);

/// Writes 3 bytes a pixel to `out` and returns how many pixels were not finite. Throws as checkTonemap does.
std::uint64_t toScreen(std::span<const Rgb> pixels, const Tonemap& tonemap, std::uint8_t* out);

/// Rounds to the nearest of 256 levels. Throws Error (usage) for an exposure outside ±100.
ScreenImage toScreen(const Image& image, const Tonemap& tonemap = {});

}  // namespace ropelight
