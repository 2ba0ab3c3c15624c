#include "app/stress/cases/probe.h"

#include <algorithm>
#include <cmath>

#include "render/film/metrics.h"

namespace ropelight {
namespace {

/// By tile and channel, over the renderings.
std::vector<Estimate> tileEstimates(const std::vector<Image>& images, int tile) {
  std::vector<std::vector<double>> values;
  for (const Image& image : images) {
    Image const means = tileMeans(image, tile);
    values.resize(3 * means.pixels.size());
    for (std::size_t t = 0; t < means.pixels.size(); ++t)
      for (int c = 0; c < 3; ++c) values[3 * t + std::size_t(c)].push_back(double(means.pixels[t][c]));
  }
  std::vector<Estimate> out;
  for (const std::vector<double>& v : values) out.push_back(estimateOf(v));
  return out;
}

/// The same samples over 16 times as many pixels, so that all cores have work: a tiny image is one task. Where photons
/// cost more than pixels do, it stays.
void spreadOverPixels(Settings& settings, int& iterations) {
  bool const pixelsCost = settings.mode != Mode::sppm || settings.photons <= 16;
  if (!pixelsCost || iterations < 16 || settings.width > 16 || settings.height > 16) return;
  settings.width *= 4;
  settings.height *= 4;
  iterations /= 16;
}

}  // namespace

std::unique_ptr<Integrator> Probe::make(const Scene& scene, const Settings& settings) const {
  return maker_ ? maker_(scene, settings, backend_) : makeIntegrator(scene, settings, backend_);
}

bool Probe::isGpu() const { return chooseBackend(backend_).cuda; }

Rendered Probe::render(const Scene& scene, const Settings& settings, int iterations) {
  tick();
  auto const integrator = make(scene, settings);
  integrator->advance(iterations);
  Rendered out{integrator->film(), integrator->stats()};
  nonFinite_ += out.stats.nonFinite;
  return out;
}

std::vector<Image> Probe::seeds(const Scene& scene, Settings settings, int iterations, int count, std::uint64_t first) {
  std::vector<Image> images;
  for (int i = 0; i < count; ++i) {
    settings.seed = seed_ + first + std::uint64_t(i);
    images.push_back(render(scene, settings, iterations).image);
  }
  return images;
}

Estimate Probe::estimate(const Scene& scene, Settings settings, int iterations, int count,
                         const std::function<double(const Image&)>& quantity) {
  spreadOverPixels(settings, iterations);
  std::vector<double> values;
  for (const Image& image : seeds(scene, settings, iterations, count)) values.push_back(quantity(image));
  return estimateOf(values);
}

Settings probeSettings(Mode mode, int size, std::uint64_t photons) {
  Settings s;
  s.mode = mode;
  s.width = s.height = size;
  s.photons = photons;
  return s;
}

double meanOfChannel(const Image& image, int channel) {
  double sum = 0;
  for (Rgb p : image.pixels) sum += double(p[channel]);
  return sum / double(image.pixels.size());
}

double meanOfAll(const Image& image) {
  return (meanOfChannel(image, 0) + meanOfChannel(image, 1) + meanOfChannel(image, 2)) / 3;
}

Estimate estimateOf(const std::vector<double>& values) {
  double const n = double(values.size());
  double sum = 0, squares = 0;
  for (double v : values) sum += v;
  double const mean = sum / n;
  for (double v : values) squares += (v - mean) * (v - mean);
  return {mean, n > 1 ? std::sqrt(squares / (n - 1) / n) : 0};
}

double largestZ(const std::vector<Image>& a, const std::vector<Image>& b, int tile, double relative) {
  std::vector<Estimate> const x = tileEstimates(a, tile), y = tileEstimates(b, tile);
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const difference = std::abs(x[i].mean - y[i].mean);
    if (difference <= relative * std::abs(y[i].mean)) continue;
    double const error = std::hypot(x[i].error, y[i].error);
    largest = std::max(largest, error > 0 ? difference / error : std::numeric_limits<double>::infinity());
  }
  return largest;
}

}  // namespace ropelight
