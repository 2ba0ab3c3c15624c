#pragma once
// From the runs of a study to what is drawn and read: medians with bands over seeds, slopes, times to reach an error.

#include <optional>
#include <string>
#include <vector>

#include "app/converge/analysis/study.h"
#include "app/plot/curve_math.h"

namespace ropelight {

enum class CurveAxis { seconds, iterations };

/// The headline figure of a sample: relMSE, or relMSE without the worst pixels.
double errorOf(const Metrics& metrics, bool trimmed);

struct BandPoint {
  double x = 0;                          ///< seconds or iterations
  double median = 0, low = 0, high = 0;  ///< over the seeds
  Interval likely;                       ///< geometricMeanInterval over the seeds
};

/// How many runs have samples: an interrupted study may hold runs without any, which all figures here leave out.
int seedsOf(const StudyMode& mode);

/// The last x that all runs of a mode reach; nothing where there is none.
std::optional<double> commonEnd(const StudyMode& mode, CurveAxis axis, bool trimmed);

/// The error of all runs of a mode at x, each run interpolated between the logarithms of its samples; nothing where x
/// lies outside one of them.
std::optional<BandPoint> bandAt(const StudyMode& mode, CurveAxis axis, bool trimmed, double x);

/// The same at common, logarithmically spaced places: those of the first run within the range of all runs, and the
/// last that all reach.
std::vector<BandPoint> bandOf(const StudyMode& mode, CurveAxis axis, bool trimmed);

/// Of log error over log x, fitted over the last decade of x (or all there is) of each run by least squares; over the
/// runs that have three samples there.
struct Slope {
  double median = unknown, low = unknown, high = unknown;  ///< over the seeds
};
Slope slopeOf(const StudyMode& mode, CurveAxis axis, bool trimmed);

/// Seconds after which a run's error is at most `error`, and stays there; over the seeds. Between two samples at the
/// crossing of the line between their logarithms; where already the first sample is below, its own time.
struct TimeTo {
  int reached = 0;                                         ///< of how many runs
  double median = unknown, low = unknown, high = unknown;  ///< seconds, over those; unknown unless all reached it
  Interval likely{unknown, unknown};                       ///< geometricMeanInterval of them
};
TimeTo timeTo(const StudyMode& mode, double error, bool trimmed);

/// One sentence on the lowest error at equal time, as far as the seeds support it: a mode is called best only where its
/// 95% interval lies below all others'.
std::string verdictOf(const StudyScene& scene, bool trimmed);

}  // namespace ropelight
