#pragma once
// An image on the host: linear Rec. 709 RGB, row 0 at the top, column 0 at the left.

#include <cmath>
#include <cstddef>
#include <vector>

#include "render/core/vec.h"

namespace ropelight {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels;  ///< width·height, row by row from the top

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), Rgb(0.0f)) {}

  Rgb& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Rgb& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

inline bool isFinitePixel(Rgb p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace ropelight
