#include <fmt/format.h>

#include <cmath>

#include "app/arguments/values.h"
#include "app/converge/analysis/figures.h"
#include "app/converge/analysis/report.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

std::string textCell(const std::string& text) {
  return text.find_first_of(",\"\r\n") == std::string::npos ? text : quoteCsv(text);
}

/// Empty where unknown.
std::string numberCell(double value) { return std::isnan(value) ? "" : formatValue(value); }

std::string cells(const ErrorSample& sample) {
  const Metrics& m = sample.metrics;
  std::string text = fmt::format("{},{}", numberCell(sample.seconds), sample.iterations);
  for (double const value : {m.relMse, m.relMseTrimmed, m.mse, m.rmse, m.psnr, m.meanError, m.maxError})
    text += "," + numberCell(value);
  return fmt::format("{},{}", text, m.nonFinite);
}

}  // namespace

std::string toCsv(const Study& study) {
  std::string csv =
      "scene,mode,seed,seconds,iterations,relmse,relmse_trimmed,mse,rmse,psnr,mean_error,max_error,non_finite,device,"
      "threads\n";
  for (const StudyScene& scene : study.scenes)
    for (const StudyMode& mode : scene.modes)
      for (const StudyRun& run : mode.runs)
        for (const ErrorSample& sample : run.samples)
          csv += fmt::format("{},{},{},{},{},{}\n", textCell(scene.name), textCell(mode.label), run.seed, cells(sample),
                             textCell(deviceOf(study, scene)), study.threads);
  return csv;
}

}  // namespace ropelight
