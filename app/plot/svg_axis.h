#pragma once
// From numbers to places along an axis of a plot.

#include <string>
#include <vector>

#include "app/plot/svg_plot.h"

namespace ropelight {

struct PlotTick {
  double value = 0;
  std::string label;  ///< empty for a minor tick
};

/// An axis fitted to values. Of a linear one the ends are ticks; a logarithmic one has a margin of 5% at either end.
class AxisScale {
 public:
  /// Values that have no place are ignored.
  AxisScale(const PlotAxis& axis, const std::vector<double>& values);

  bool hasPlace(double value) const;
  /// 0 at the low end, 1 at the high end.
  double position(double value) const;
  const std::vector<PlotTick>& ticks() const { return ticks_; }

 private:
  void fitLinear(const std::vector<double>& values);
  void fitLogarithmic(const std::vector<double>& values);
  void fitNames(const std::vector<std::string>& names);

  bool logarithmic_;
  double low_ = 0, high_ = 1;
  std::vector<PlotTick> ticks_;
};

/// Of a logarithmic axis: "0.01", "100", from 10⁴ up and 10⁻³ down in powers of ten: "2·10⁵", "10⁻³".
std::string tickLabel(double value);

}  // namespace ropelight
