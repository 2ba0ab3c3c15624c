#include "app/converge/study/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/run/report.h"
#include "render/core/error.h"
#include "render/image_files/exr.h"

namespace ropelight {
namespace {

constexpr std::uint64_t seedStep = 0x9E3779B97F4A7C15u;  // the halves' seeds: far from those that people choose
constexpr double trialShare = 0.1;                       // of the time, for each of the two that may make it
constexpr double biasExponent = 2.0 / 3.0;               // of bias² over iterations, at the default α
constexpr double referenceRadius = 0.5;  // of the automatic one: a 16th of the bias², four times the noise

/// One half of a reference, and what describes it.
struct Half {
  Image film;
  Stats stats;
};

/// At least one iteration; ends early where it is asked to, or interrupted.
Half renderHalf(Integrator& integrator, const ReferenceOptions& options) {
  double const seconds = options.seconds / 2;
  std::uint64_t const iterations = std::max<std::uint64_t>(1, options.iterations / 2);
  do {
    Stats const so = integrator.stats();
    std::uint64_t batch = 1;
    if (options.seconds > 0 && so.seconds > 0)
      batch = std::uint64_t(std::clamp((seconds - so.seconds) / so.seconds * double(so.iterations), 1.0,
                                       std::min(4096.0, double(so.iterations))));
    if (options.seconds == 0) batch = std::min<std::uint64_t>(64, iterations - so.iterations);
    if (!integrator.advance(int(batch))) break;
    if (options.stop && options.stop()) break;
  } while (options.seconds > 0 ? integrator.stats().seconds < seconds : integrator.stats().iterations < iterations);
  return {integrator.film(), integrator.stats()};
}

/// The mean of two halves of m and n iterations; ((a − b)²·m·n)/(m + n)² estimates the square of its own error.
Image meanOf(const Half& a, const Half& b) {
  double const m = double(a.stats.iterations), n = double(b.stats.iterations);
  Image mean(a.film.width, a.film.height);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = Rgb((Vec3d(a.film.pixels[i]) * m + Vec3d(b.film.pixels[i]) * n) / (m + n));
  return mean;
}

void measureNoise(const Half& a, const Half& b, StudyReference& reference) {
  double const m = double(a.stats.iterations), n = double(b.stats.iterations), share = m * n / ((m + n) * (m + n));
  double relative = 0, squares = 0;
  for (std::size_t i = 0; i < reference.image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      double const d = double(a.film.pixels[i][c]) - double(b.film.pixels[i][c]);
      double const mean = double(reference.image.pixels[i][c]);
      squares += d * d * share;
      if (d != 0) relative += d * d * share / (mean * mean + reference.epsilon);
    }
  double const values = 3.0 * double(reference.image.pixels.size());
  reference.noise = relative / values;
  reference.variance = squares / values;
}

/// Where references are made.
struct Workshop {
  const Scene& scene;
  const Settings& base;
  const BackendChoice& backend;
  std::shared_ptr<SceneCache> cache;
};

StudyReference makeBy(const std::string& mode, const ReferenceOptions& options, const Workshop& shop) {
  std::vector<ModeSpec> const specs = parseModes(mode, shop.base);
  if (specs.size() != 1) throw Error(fmt::format("--reference-mode {}: name one mode", mode), ExitCode::usage);
  Settings settings = specs[0].settings;
  settings.seed ^= seedStep;
  auto const integrator = makeIntegrator(shop.scene, settings, shop.backend, nullptr, shop.cache);
  if (settings.mode == Mode::sppm && settings.radius == 0) {
    settings.radius = referenceRadius * integrator->stats().settings.radius;
    integrator->restart(shop.scene.camera, settings);
  }
  Half const first = renderHalf(*integrator, options);
  settings.seed += seedStep;
  if (!integrator->restart(shop.scene.camera, settings))
    throw Error("the reference's second half needs another integrator", ExitCode::internal);
  Half const second = renderHalf(*integrator, options);

  StudyReference reference;
  reference.image = meanOf(first, second);
  reference.epsilon = relativeEpsilon(reference.image, options.epsilon);
  measureNoise(first, second, reference);
  reference.origin = fmt::format("{}{}, two halves of {} and {} iterations in {:.1f} s on {}", specs[0].label,
                                 settings.radius > 0 ? fmt::format(" from radius {:.3g}", settings.radius) : "",
                                 first.stats.iterations, second.stats.iterations,
                                 first.stats.seconds + second.stats.seconds, second.stats.device);
  reference.stats = second.stats;
  reference.stats.iterations += first.stats.iterations;
  reference.stats.seconds += first.stats.seconds;
  reference.mode = settings.mode;
  return reference;
}

/// Which of the two will probably have less error: path its noise; sppm its noise and its bias, which is how far the
/// two trials differ beyond their noise.
bool pathIsBetter(const ReferenceOptions& options, const Workshop& shop) {
  ReferenceOptions trial = options;
  trial.seconds *= trialShare;
  trial.iterations = std::uint64_t(double(trial.iterations) * trialShare);
  StudyReference const path = makeBy("path", trial, shop), sppm = makeBy("sppm", trial, shop);
  double const apart = compareImages(path.image, sppm.image, {.epsilon = sppm.epsilon}).relMse;
  double const bias2 = std::max(0.0, apart - path.noise - sppm.noise);
  return path.noise * trialShare <= sppm.noise * trialShare + bias2 * std::pow(trialShare, biasExponent);
}

}  // namespace

StudyReference makeReference(const ReferenceOptions& options, const Scene& scene, const Settings& base,
                             const BackendChoice& backend, std::shared_ptr<SceneCache> cache) {
  Workshop const shop{scene, base, backend, std::move(cache)};
  if (!options.mode.empty()) return makeBy(options.mode, options, shop);
  return makeBy(pathIsBetter(options, shop) ? "path" : "sppm", options, shop);
}

void saveReference(const ReferenceOptions& options, const StudyReference& reference, const Scene& scene) {
  Metadata metadata = imageMetadata(reference.stats.settings, scene, reference.stats);
  metadata.emplace_back("reference-origin", reference.origin);
  metadata.emplace_back("reference-noise", reference.noise);
  metadata.emplace_back("reference-variance", reference.variance);
  writeExr(forScene(options.save, scene), reference.image, metadata);
}

}  // namespace ropelight
