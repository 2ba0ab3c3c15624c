#pragma once
// `ropelight compare`: how far an image is from a reference.

#include <optional>
#include <string>
#include <vector>

namespace ropelight {

struct CompareOptions {
  std::string image;                ///< .exr or .png
  std::string reference;            ///< .exr or .png, of the same size
  std::string metric = "relmse";    ///< what the threshold is for: one of compareMetricNames()
  std::optional<double> threshold;  ///< the check fails above it; for psnr, below it
  std::optional<double> epsilon;    ///< of relMSE; by default 0.01·mean(reference²)
  std::string errorImage;           ///< .exr or .png to write the signed relative error to; empty: none
  std::string flipImage;            ///< .exr or .png to write the FLIP map to, grey, 0 to 1; empty: none
  std::string json;                 ///< file for the figures, "-" for standard output; empty: none
};

/// mse, rmse, relmse, relmse-trimmed, psnr, mean (|signed mean error|), max, flip (its mean).
std::vector<std::string> compareMetricNames();

/// Prints a table (on standard error where standard output is for JSON) and writes the files asked for. Returns the
/// exit code: 6 where the metric misses the threshold, is NaN, or either image has pixels that are not finite; else 0.
/// Throws Error for files that cannot be read or written, different sizes and an unknown metric.
int runCompare(const CompareOptions& options);

}  // namespace ropelight
