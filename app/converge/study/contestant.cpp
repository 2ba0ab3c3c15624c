#include "app/converge/study/contestant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/results/timing.h"
#include "app/converge/analysis/curves.h"

namespace ropelight {
namespace {

constexpr double spacing = 1.3335214321633240;  // 8 samples per decade
constexpr double batchSeconds = 0.1;
constexpr std::uint64_t mostIterations = 4096;
constexpr double doubtfulShare = 0.5;  // of an error that the reference's own noise may make up
constexpr double doubtfulBias = 0.25;  // of path's mean square error

double channelMean(const std::vector<Vec3d>& pixels) {
  double sum = 0;
  for (const Vec3d& p : pixels) sum += p.x + p.y + p.z;
  return sum / (3.0 * double(pixels.size()));
}

/// Path tracing has no bias: what its runs have in common against the reference is the reference's own, or light that
/// paths are too rare to find.
std::string biasWarning(const StudyMode& mode) {
  bool const known = mode.split.referenceVariance >= 0;
  if (mode.settings.mode != Mode::path || !known || !(mode.split.bias2 > doubtfulBias * mode.split.mse)) return "";
  return fmt::format(
      "{:.0f}% of this mode's mean square error is bias, which path tracing has none of: the reference "
      "is biased itself, or paths hardly find the light",
      100 * mode.split.bias2 / mode.split.mse);
}

std::string noiseWarning(const StudyReference& reference, const Metrics& metrics, double error) {
  if (std::isnan(reference.noise)) return "how noisy the reference is itself is not known";
  if (!(reference.noise > doubtfulShare * error) && !(reference.variance > doubtfulShare * metrics.mse)) return "";
  return fmt::format(
      "the reference's own noise, {:.2g}, makes up much of the error {:.2g} at the end: a better "
      "reference would show less",
      reference.noise, error);
}

/// The reasons for doubt, in order.
std::string warningsOf(const StudyMode& mode, const StudyReference& reference, bool trimmed) {
  std::string text;
  auto const add = [&](const std::string& reason) { text += (text.empty() || reason.empty() ? "" : "; ") + reason; };
  for (const StudyRun& run : mode.runs)
    if (text.empty() && !run.samples.empty())
      add(noiseWarning(reference, run.samples.back().metrics, errorOf(run.samples.back().metrics, trimmed)));
  add(biasWarning(mode));
  if (mode.settings.mode == Mode::sppm && reference.mode == Mode::sppm)
    add("the reference is by sppm too and shares a part of this mode's bias, which the error leaves out");
  return text;
}

}  // namespace

Contestant::Contestant(const Scene& scene, const ModeSpec& spec, const RunnerOptions& options,
                       std::shared_ptr<SceneCache> cache)
    : scene_(scene), options_(options), asked_(spec.settings), cache_(std::move(cache)), schedule_(spacing) {
  mode_.setupSeconds =
      secondsOf([&] { integrator_ = makeIntegrator(scene_, asked_, options_.backend, nullptr, cache_); });
  Stats const stats = integrator_->stats();
  mode_.label = spec.label;
  mode_.settings = stats.settings;
  mode_.accel = stats.accel;
  mode_.kernels = stats.kernelRow;
  mode_.treeSeconds = stats.treeSeconds;
}

void Contestant::warmUp() {
  mode_.firstIterationSeconds = secondsOf([&] { integrator_->advance(1); });
}

void Contestant::start(int k) {
  Settings settings = asked_;
  settings.seed += std::uint64_t(k);
  if (!integrator_->restart(scene_.camera, settings))
    integrator_ = makeIntegrator(scene_, settings, options_.backend, nullptr, cache_);
  mode_.runs.push_back({settings.seed, {}});
  schedule_.restart();
  seconds_ = latestSeconds_ = 0;
  iterations_ = latestBatch_ = 0;
  done_ = false;
}

std::uint64_t Contestant::nextBatch() const {
  const RunLimits& limits = options_.limits;
  double const left = limits.seconds > 0 ? limits.seconds - seconds_ : batchSeconds;
  double const untilDue = limits.seconds > 0 ? schedule_.next() - seconds_ : batchSeconds;
  double const wanted = std::min({batchSeconds, left, untilDue});
  double const fitting = latestSeconds_ > 0 ? wanted / latestSeconds_ * double(latestBatch_) : 1;
  std::uint64_t batch =
      std::uint64_t(std::clamp(fitting, 1.0, double(std::clamp<std::uint64_t>(2 * latestBatch_, 1, mostIterations))));
  if (limits.iterations > 0) batch = std::min(batch, limits.iterations - iterations_);
  if (limits.seconds == 0)
    batch = std::min(batch, std::max<std::uint64_t>(1, std::uint64_t(schedule_.next()) -
                                                           std::min(iterations_, std::uint64_t(schedule_.next()))));
  return batch;
}

void Contestant::advance(const StudyReference& reference) {
  const RunLimits& limits = options_.limits;
  latestBatch_ = nextBatch();
  latestSeconds_ = secondsOf([&] { integrator_->advance(int(latestBatch_)); });
  seconds_ += latestSeconds_;
  iterations_ += latestBatch_;
  done_ =
      (limits.seconds > 0 && seconds_ >= limits.seconds) || (limits.iterations > 0 && iterations_ >= limits.iterations);
  if (done_ || schedule_.due(limits.seconds > 0 ? seconds_ : double(iterations_))) sample(reference);
}

void Contestant::sample(const StudyReference& reference) {
  schedule_.taken(options_.limits.seconds > 0 ? seconds_ : double(iterations_));
  mode_.runs.back().samples.push_back(
      {seconds_, iterations_, compareImages(integrator_->film(), reference.image, {.epsilon = reference.epsilon})});
}

void Contestant::takePicture() {
  mode_.picture = integrator_->film();
  mode_.pictureSeconds = seconds_;
  mode_.pictureIterations = iterations_;
}

void Contestant::endRun() {
  Image const film = integrator_->film();
  sum_.resize(film.pixels.size(), Vec3d(0));
  squares_.resize(film.pixels.size(), Vec3d(0));
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    Vec3d const p(film.pixels[i]);
    sum_[i] += p;
    squares_[i] += p * p;
  }
  ++ended_;
}

ErrorSplit Contestant::split(const StudyReference& reference) const {
  ErrorSplit split;
  if (ended_ == 0) return split;
  double const runs = ended_;
  std::vector<Vec3d> variance(sum_.size()), offset(sum_.size());
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    Vec3d const mean = sum_[i] / runs, d = mean - Vec3d(reference.image.pixels[i]);
    variance[i] = glm::max(squares_[i] / runs - mean * mean, Vec3d(0));
    offset[i] = d * d;
  }
  double const spread = channelMean(variance), distance = channelMean(offset);
  split.mse = distance + spread;  // the mean over the runs of mean((run − reference)²)
  split.referenceVariance = reference.variance;
  if (ended_ < 2) return split;
  split.variance = spread * runs / (runs - 1);
  double const known = reference.variance >= 0 ? reference.variance : 0;
  split.bias2 = distance - split.variance / runs - known;
  return split;
}

StudyMode Contestant::result(const StudyReference& reference, bool trimmed) {
  mode_.split = split(reference);
  if (ended_ > 0) mode_.runs.resize(std::size_t(ended_));  // without one that was stopped half-way
  mode_.referenceWarning = warningsOf(mode_, reference, trimmed);
  return std::move(mode_);
}

}  // namespace ropelight
