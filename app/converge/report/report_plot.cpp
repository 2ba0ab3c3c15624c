#include <fmt/format.h>

#include <cmath>

#include "app/converge/analysis/figures.h"
#include "app/converge/analysis/report.h"

namespace ropelight {
namespace {

Curve curveOf(const StudyMode& mode, CurveAxis axis, bool trimmed) {
  Curve curve{mode.label, {}, true};
  bool const banded = seedsOf(mode) > 1;
  for (const BandPoint& p : bandOf(mode, axis, trimmed))
    curve.points.push_back({p.x, p.median, banded ? p.low : noValue, banded ? p.high : noValue});
  double const slope = slopeOf(mode, axis, trimmed).median;
  if (curve.points.empty())
    curve.name += ", no error known";
  else if (std::isfinite(slope))
    curve.name += ", slope " + slopeFigure(slope);
  return curve;
}

std::string captionOf(const Study& study, const StudyScene& scene) {
  std::string const seeds = study.seeds > 1
                                ? fmt::format("median of {} seeds, bands from the least to the largest", study.seeds)
                                : "one seed, so that there are no bands";
  return fmt::format("{}, {}, ropelight {}; {}; slopes over the last decade\nε = {}; reference: {}\n{}",
                     deviceOf(study, scene), threadsText(study.threads), study.version, seeds,
                     figure(scene.reference.epsilon), scene.reference.origin, study.command);
}

}  // namespace

LinePlot errorPlot(const Study& study, const StudyScene& scene, CurveAxis axis) {
  bool const timed = axis == CurveAxis::seconds;
  LinePlot plot;
  plot.title = fmt::format("{}: error against {}", scene.name, timed ? "run time" : "iterations");
  plot.caption = captionOf(study, scene);
  plot.x = {timed ? "run time, s" : "iterations", true, {}};
  plot.y = {metricName(study.trimmed), true, {}};
  for (const StudyMode& mode : scene.modes) plot.curves.push_back(curveOf(mode, axis, study.trimmed));
  return plot;
}

}  // namespace ropelight
