#pragma once
// FLIP: how different two images look to one who flips between them.

#include "render/film/image.h"

namespace ropelight {

/// Pixels a degree of the visual angle, seen at 0.7 m on a screen 0.7 m wide with 3840 pixels: 0.7·(3840/0.7)·π/180.
inline constexpr double defaultPixelsPerDegree = 67.02064327658226;

struct FlipResult {
  double mean = 0;  ///< of the map; NaN for images without pixels
  Image map;        ///< grey, 0 (looks equal) to 1 for every pixel, not sRGB-encoded
};

/// LDR-FLIP of Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator
/// for Alternating Images". Both images are linear Rec. 709 and are seen as a screen shows them with the default
/// Tonemap (exposure 0, values clamped to [0, 1]), short of its rounding to 8 bits. Beyond its edges an image goes on
/// with the edge's pixels. A pixel that is not finite in either image counts as 1 and is black to its neighbours.
/// Symmetric in the images; the same bits for any number of threads. pixelsPerDegree ≥ 1. Throws Error (badInput) for
/// images of different sizes.
FlipResult flip(const Image& image, const Image& reference, double pixelsPerDegree = defaultPixelsPerDegree);

}  // namespace ropelight
