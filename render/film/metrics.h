#pragma once
// How far an image is from a reference.

#include <array>
#include <cstdint>
#include <optional>

#include "render/film/image.h"

namespace ropelight {

struct MetricsOptions {
  std::optional<double> epsilon;  ///< ε of relMSE, squared radiance; by default 0.01·mean(b²)
  double trimmed = 0.001;         ///< share of the worst pixels that relMseTrimmed leaves out, [0, 1)
};

/// With a the image and b the reference; sums run over the pixels that are finite in both and over the channels, in
/// double. Without such a pixel all values are NaN.
struct Metrics {
  double mse = 0;            ///< mean of (a − b)²
  double rmse = 0;           ///< √mse
  double relMse = 0;         ///< mean of (a − b)²/(b² + ε); a term without error is 0 (Rousselle et al. 2011)
  double relMseTrimmed = 0;  ///< relMse without the ⌊trimmed·pixels⌋ worst pixels, each the mean of its channels
  double psnr = 0;           ///< dB: 10 log₁₀(peak²/mse), peak the largest channel of b; infinite for equal images
  double meanError = 0;      ///< mean of a − b, signed
  double maxError = 0;       ///< largest |a − b| of a channel
  double epsilon = 0;        ///< the ε that was used
  std::array<double, 3> mean = {};           ///< of a, by channel
  std::array<double, 3> meanReference = {};  ///< of b, by channel
  std::uint64_t pixels = 0;                  ///< finite in both
  std::uint64_t nonFinite = 0;               ///< pixels of a with a NaN or an infinity
  std::uint64_t nonFiniteReference = 0;      ///< the same of b
};

/// Throws Error (badInput) for images of different sizes.
Metrics compareImages(const Image& image, const Image& reference, const MetricsOptions& options = {});

/// The signed relative error (a − b)/√(b² + ε), channel mean, as colour: red where the image is too bright, blue where
/// too dark, full at an error of 1 (and beyond in linear files), green where a pixel is not finite.
/// Throws Error (badInput) for images of different sizes.
Image errorImage(const Image& image, const Image& reference, const MetricsOptions& options = {});

/// Means of tile × tile pixels, ⌈width/tile⌉ × ⌈height/tile⌉ of them; those at the right and lower edges hold what is
/// left. A non-finite pixel makes its tile non-finite. tile ≥ 1.
Image tileMeans(const Image& image, int tile);

}  // namespace ropelight
