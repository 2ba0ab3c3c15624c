#include "render/film/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "render/core/error.h"

namespace ropelight {
namespace {

void requireSameSize(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    throw Error(
        fmt::format("the images differ in size: {} x {} and {} x {} pixels; compare images of the same film size",
                    image.width, image.height, reference.width, reference.height));
}

/// 0.01·mean(b²) over the finite pixels of both images, unless the options fix it.
double resolveEpsilon(const Image& image, const Image& reference, const MetricsOptions& options) {
  if (options.epsilon) return *options.epsilon;
  double sum = 0;
  std::uint64_t pixels = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    if (!isFinitePixel(image.pixels[i]) || !isFinitePixel(reference.pixels[i])) continue;
    const Vec3d b(reference.pixels[i]);
    sum += glm::dot(b, b);
    ++pixels;
  }
  return pixels == 0 ? 0.0 : 0.01 * sum / (3.0 * double(pixels));
}

/// (a − b)²/(b² + ε), 0 where a equals b even if both are black and ε is 0.
double relativeSquare(double a, double b, double epsilon) {
  return a == b ? 0.0 : (a - b) * (a - b) / (b * b + epsilon);
}

double meanWithoutWorst(std::vector<double>& errors, double trimmed) {
  const auto kept = std::ptrdiff_t(errors.size() - std::size_t(trimmed * double(errors.size())));
  std::nth_element(errors.begin(), errors.begin() + kept - 1, errors.end());
  return std::accumulate(errors.begin(), errors.begin() + kept, 0.0) / double(kept);
}

double peakSignalToNoise(double peak, double mse) {
  return mse == 0 ? std::numeric_limits<double>::infinity() : 10.0 * std::log10(peak * peak / mse);
}

/// What one pass over the pixels adds up.
struct Sums {
  Vec3d squares{0.0}, errors{0.0}, image{0.0}, reference{0.0};
  double maxError = 0, peak = 0;
  std::vector<double> relative;  ///< mean relative square of each finite pixel

  void add(Vec3d a, Vec3d b, double epsilon) {
    const Vec3d error = a - b;
    squares += error * error;
    errors += error;
    image += a;
    reference += b;
    double sum = 0;
    for (int channel = 0; channel < 3; ++channel) {
      maxError = std::max(maxError, std::abs(error[channel]));
      peak = std::max(peak, b[channel]);
      sum += relativeSquare(a[channel], b[channel], epsilon);
    }
    relative.push_back(sum / 3.0);
  }
};

double channelMean(Vec3d v) { return (v.x + v.y + v.z) / 3.0; }
std::array<double, 3> toArray(Vec3d v) { return {v.x, v.y, v.z}; }

void fillValues(Metrics& metrics, Sums& sums, double trimmed) {
  const double n = double(metrics.pixels);  // 0/0 is the NaN that stands for "nothing to compare"
  metrics.mse = channelMean(sums.squares) / n;
  metrics.rmse = std::sqrt(metrics.mse);
  metrics.relMse = std::accumulate(sums.relative.begin(), sums.relative.end(), 0.0) / n;
  metrics.relMseTrimmed = sums.relative.empty() ? metrics.relMse : meanWithoutWorst(sums.relative, trimmed);
  metrics.psnr = peakSignalToNoise(sums.peak, metrics.mse);
  metrics.meanError = channelMean(sums.errors) / n;
  metrics.maxError = sums.relative.empty() ? metrics.mse : sums.maxError;
  metrics.mean = toArray(sums.image / n);
  metrics.meanReference = toArray(sums.reference / n);
}

}  // namespace

Metrics compareImages(const Image& image, const Image& reference, const MetricsOptions& options) {
  requireSameSize(image, reference);
  assert(options.trimmed >= 0 && options.trimmed < 1);
  Metrics metrics;
  metrics.epsilon = resolveEpsilon(image, reference, options);
  Sums sums;
  sums.relative.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const bool finite = isFinitePixel(image.pixels[i]), finiteReference = isFinitePixel(reference.pixels[i]);
    if (!finite) ++metrics.nonFinite;
    if (!finiteReference) ++metrics.nonFiniteReference;
    if (finite && finiteReference) sums.add(Vec3d(image.pixels[i]), Vec3d(reference.pixels[i]), metrics.epsilon);
  }
  metrics.pixels = sums.relative.size();
  fillValues(metrics, sums, options.trimmed);
  return metrics;
}

Image errorImage(const Image& image, const Image& reference, const MetricsOptions& options) {
  requireSameSize(image, reference);
  const double epsilon = resolveEpsilon(image, reference, options);
  Image result(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (!isFinitePixel(image.pixels[i]) || !isFinitePixel(reference.pixels[i])) {
      result.pixels[i] = Rgb(0.0f, 1.0f, 0.0f);
      continue;
    }
    const Vec3d a(image.pixels[i]), b(reference.pixels[i]);
    double error = 0;
    for (int channel = 0; channel < 3; ++channel)
      error += std::copysign(std::sqrt(relativeSquare(a[channel], b[channel], epsilon)), a[channel] - b[channel]) / 3.0;
    result.pixels[i] = Rgb(float(std::max(error, 0.0)), 0.0f, float(std::max(-error, 0.0)));
  }
  return result;
}

Image tileMeans(const Image& image, int tile) {
  assert(tile >= 1);
  const auto tilesAlong = [tile](int size) { return size / tile + (size % tile != 0); };
  Image means(tilesAlong(image.width), tilesAlong(image.height));
  for (int ty = 0; ty < means.height; ++ty)
    for (int tx = 0; tx < means.width; ++tx) {
      const int left = tx * tile, right = left + std::min(tile, image.width - left);
      const int top = ty * tile, bottom = top + std::min(tile, image.height - top);
      Vec3d sum(0.0);
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) sum += Vec3d(image.at(x, y));
      means.at(tx, ty) = Rgb(sum / (double(right - left) * double(bottom - top)));
    }
  return means;
}

}  // namespace ropelight
