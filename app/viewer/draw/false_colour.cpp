#include "app/viewer/draw/false_colour.h"

#include <algorithm>
#include <cstddef>

namespace ropelight::view {

std::array<float, 3> falseColour(float t) {
  constexpr std::size_t steps = falseColourPoints.size() - 1;
  float const place = (t > 0 ? std::min(t, 1.0f) : 0.0f) * float(steps);
  std::size_t const low = std::min(std::size_t(place), steps - 1);
  float const share = place - float(low);
  std::array<float, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = falseColourPoints[low][c] + share * (falseColourPoints[low + 1][c] - falseColourPoints[low][c]);
  return colour;
}

}  // namespace ropelight::view
