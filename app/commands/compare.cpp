#include "app/commands/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/run/output.h"
#include "app/run/standard_streams.h"
#include "render/core/error.h"
#include "render/film/flip.h"
#include "render/film/metrics.h"
#include "render/image_files/image_file.h"

namespace ropelight {
namespace {

struct Comparison {
  Metrics metrics;
  FlipResult flip;
};

/// One row of the table: its name on the command line and in JSON, its label, its value.
struct Figure {
  const char* name;
  const char* label;
  double (*value)(const Comparison&);
};

constexpr Figure figures[] = {
    {"mse", "MSE", [](const Comparison& c) { return c.metrics.mse; }},
    {"rmse", "RMSE", [](const Comparison& c) { return c.metrics.rmse; }},
    {"relmse", "relMSE", [](const Comparison& c) { return c.metrics.relMse; }},
    {"relmse-trimmed", "relMSE without worst 0.1%", [](const Comparison& c) { return c.metrics.relMseTrimmed; }},
    {"psnr", "PSNR (dB)", [](const Comparison& c) { return c.metrics.psnr; }},
    {"mean", "mean error", [](const Comparison& c) { return c.metrics.meanError; }},
    {"max", "largest error", [](const Comparison& c) { return c.metrics.maxError; }},
    {"flip", "mean FLIP", [](const Comparison& c) { return c.flip.mean; }},
};

const Figure& figureOf(const std::string& name) {
  for (const Figure& figure : figures)
    if (figure.name == name) return figure;
  throw Error(fmt::format("--metric {}: expected {}; name one of them", name, fmt::join(compareMetricNames(), ", ")),
              ExitCode::usage);
}

void checkOptions(const CompareOptions& options) {
  figureOf(options.metric);
  if (options.threshold && std::isnan(*options.threshold))
    throw Error("--threshold nan: expected a number; give one", ExitCode::usage);
  if (options.epsilon && !(std::isfinite(*options.epsilon) && *options.epsilon >= 0))
    throw Error(fmt::format("--epsilon {}: expected a number from 0; give one", *options.epsilon), ExitCode::usage);
  for (const std::string& image : {options.errorImage, options.flipImage})
    if (!image.empty()) imageFormatOf(image);
  requireOutputs({options.errorImage, options.flipImage, options.json}, {options.image, options.reference});
}

/// An image, with a note of what its file says and the figures ignore.
Image readNoted(const std::string& file) {
  Image image = readImage(file);
  if (const std::string ignored = ignoredColours(file); !ignored.empty())
    printError("note: {}: not heeded: {}; the values are taken as linear Rec. 709's", file, ignored);
  return image;
}

/// Written so that NaN misses every threshold; so do pixels that the figures had to leave out.
bool meetsThreshold(const CompareOptions& options, const Comparison& comparison) {
  if (!options.threshold) return true;
  if (comparison.metrics.nonFinite > 0 || comparison.metrics.nonFiniteReference > 0) return false;
  const double value = figureOf(options.metric).value(comparison);
  return options.metric == "psnr" ? value >= *options.threshold : std::abs(value) <= *options.threshold;
}

void printRow(std::FILE* out, const char* label, const std::string& value) {
  printTo(out, "  {:<27}{}\n", label, value);
}

std::string formatRgb(const std::array<double, 3>& c) { return fmt::format("{:.6g} {:.6g} {:.6g}", c[0], c[1], c[2]); }

void printTable(std::FILE* out, const CompareOptions& options, const Comparison& comparison, const Image& image) {
  const Metrics& metrics = comparison.metrics;
  printTo(out, "{} against {}, {} x {} pixels\n", options.image, options.reference, image.width, image.height);
  for (const Figure& figure : figures) printRow(out, figure.label, fmt::format("{:.6g}", figure.value(comparison)));
  printRow(out, "mean of the image", formatRgb(metrics.mean));
  printRow(out, "mean of the reference", formatRgb(metrics.meanReference));
  printRow(out, "epsilon of relMSE", fmt::format("{:.6g}", metrics.epsilon));
  printRow(out, "pixels not finite", fmt::format("{}, reference {}", metrics.nonFinite, metrics.nonFiniteReference));
  if (options.threshold)
    printTo(out, "{}: {} {} {:.6g}\n", meetsThreshold(options, comparison) ? "passed" : "FAILED", options.metric,
            options.metric == "psnr" ? "at least" : "at most", *options.threshold);
}

/// Values that are not finite become null.
nlohmann::ordered_json toJson(const CompareOptions& options, const Comparison& comparison, const Image& image) {
  const Metrics& metrics = comparison.metrics;
  nlohmann::ordered_json json = {
      {"image", options.image}, {"reference", options.reference}, {"width", image.width}, {"height", image.height}};
  for (const Figure& figure : figures) json[figure.name] = figure.value(comparison);
  json["image-mean"] = metrics.mean;
  json["reference-mean"] = metrics.meanReference;
  json["epsilon"] = metrics.epsilon;
  json["pixels"] = metrics.pixels;
  json["non-finite"] = metrics.nonFinite;
  json["reference-non-finite"] = metrics.nonFiniteReference;
  if (options.threshold) {
    json["metric"] = options.metric;
    json["threshold"] = *options.threshold;
    json["passed"] = meetsThreshold(options, comparison);
  }
  return json;
}

}  // namespace

std::vector<std::string> compareMetricNames() {
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  return names;
}

int runCompare(const CompareOptions& options) {
  checkOptions(options);
  const Image image = readNoted(options.image), reference = readNoted(options.reference);
  const MetricsOptions metricsOptions = {.epsilon = options.epsilon};
  const Comparison comparison = {compareImages(image, reference, metricsOptions), flip(image, reference)};
  printTable(options.json == "-" ? stderr : stdout, options, comparison, image);

  std::vector<std::function<void()>> writers;
  if (!options.errorImage.empty())
    writers.push_back([&] { writeImage(options.errorImage, errorImage(image, reference, metricsOptions)); });
  if (!options.flipImage.empty()) writers.push_back([&] { writeImage(options.flipImage, comparison.flip.map); });
  if (!options.json.empty()) writers.push_back([&] { writeJson(options.json, toJson(options, comparison, image)); });
  writeAll(writers);
  return int(meetsThreshold(options, comparison) ? ExitCode::done : ExitCode::checkFailed);
}

}  // namespace ropelight
