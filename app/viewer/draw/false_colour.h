#pragma once
// The ramp of the false colours, as the shader and the panel's legend have it.

#include <array>

namespace ropelight::view {

/// Screen colours (sRGB-encoded, [0, 1]) at equal steps from the scale's low end to its high end: black, indigo, blue,
/// teal, green, yellow, red, white. The shader's array has as many.
inline constexpr std::array<std::array<float, 3>, 8> falseColourPoints = {{{0.00f, 0.00f, 0.00f},
                                                                           {0.25f, 0.05f, 0.50f},
                                                                           {0.13f, 0.30f, 0.90f},
                                                                           {0.05f, 0.62f, 0.68f},
                                                                           {0.25f, 0.75f, 0.25f},
                                                                           {0.98f, 0.88f, 0.15f},
                                                                           {0.88f, 0.18f, 0.12f},
                                                                           {1.00f, 1.00f, 1.00f}}};

/// The colour at t, linear between the points; t is clamped to [0, 1], NaN is 0.
std::array<float, 3> falseColour(float t);

}  // namespace ropelight::view
