#pragma once
// A study as files: one self-contained HTML page, CSV, and SVG plots.

#include <string>
#include <vector>

#include "app/converge/analysis/curves.h"
#include "app/plot/svg_plot.h"

namespace ropelight {

/// The errors for which the report's table gives the time to reach them.
inline constexpr double reportedErrors[] = {0.1, 0.01, 0.001};

/// Error against seconds or iterations of all modes of a scene, log-log, with bands over the seeds; the fitted slopes
/// are part of the curves' names.
LinePlot errorPlot(const Study& study, const StudyScene& scene, CurveAxis axis);

/// One page that needs no network: for every scene the verdict, the table of times to reach an error, start-up, slopes,
/// bias and variance, both plots, pictures at equal time with their error maps beside the reference, and the settings;
/// before them, with more than one scene, one table of all scenes × modes.
std::string toHtml(const Study& study);

/// RFC 4180, one line per sample: scene,mode,seed,seconds,iterations,relmse,relmse_trimmed,mse,rmse,psnr,mean_error,
/// max_error,non_finite,device,threads.
std::string toCsv(const Study& study);

}  // namespace ropelight
