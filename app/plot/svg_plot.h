#pragma once
// Line plots as SVG text: one self-contained file, the same bytes for the same numbers.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace ropelight {

inline constexpr double noValue = std::numeric_limits<double>::quiet_NaN();

/// low, high: ends of the band around y, noValue where there is none. estimated: scaled up or cut short; drawn hollow,
/// with dashed lines to its neighbours.
struct CurvePoint {
  double x = 0, y = 0;
  double low = noValue, high = noValue;
  bool estimated = false;
};

struct Curve {
  std::string name;
  std::vector<CurvePoint> points;  ///< in the order that lines join them
  bool connected = true;           ///< else markers alone
};

struct PlotAxis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
  std::vector<std::string> names;  ///< where not empty: the axis has these places, at 0, 1, …
};

/// caption: what is needed to repeat the measurement (device, seed, settings); wrapped below the plot. Every '\n' in it
/// begins a new line.
struct LinePlot {
  std::string title;
  std::string caption;
  PlotAxis x, y;
  std::vector<Curve> curves;
};

/// The text of an SVG file on a light background. Points are left out where they are not finite, or not positive on a
/// logarithmic axis; a band's end likewise. Colours are Okabe & Ito's (2008), which the colour-blind can tell apart,
/// and every curve has a marker of its own.
std::string toSvg(const LinePlot& plot);

/// Of the index-th curve of a plot, "#0072b2"; they repeat.
const char* curveColour(std::size_t index);

/// Where plots are drawn, in pixels of the SVG's own coordinates.
struct PlotArea {
  double left = 84, top = 52, right = 640, bottom = 424;
};

}  // namespace ropelight
