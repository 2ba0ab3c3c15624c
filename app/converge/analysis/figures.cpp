#include "app/converge/analysis/figures.h"

#include <fmt/format.h>

#include <cmath>

#include "app/plot/svg_axis.h"

namespace ropelight {

std::string figure(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0) return "0";
  double const step = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  std::string const digits = tickLabel(std::round(std::abs(value) / step) * step);
  return (value < 0 ? "−" : "") + digits;
}

std::string slopeFigure(double value) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{}{:.2f}", value < -0.005 ? "−" : "", std::abs(value));
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  return seconds < 1 ? figure(seconds * 1e3) + " ms" : figure(seconds) + " s";
}

const char* metricName(bool trimmed) { return trimmed ? "trimmed relMSE" : "relMSE"; }

std::string threadsText(int threads) {
  if (threads == 0) return "all CPU threads";
  return fmt::format("{} CPU thread{}", threads, threads == 1 ? "" : "s");
}

const std::string& deviceOf(const Study& study, const StudyScene& scene) {
  return scene.device.empty() ? study.device : scene.device;
}

}  // namespace ropelight
