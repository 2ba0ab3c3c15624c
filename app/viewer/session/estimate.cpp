#include "app/viewer/session/estimate.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>

namespace ropelight::view {

Settings draftOf(const Settings& settings, const FilmDesc& film, int scale, FirstRadii resolved) {
  Settings s = settings;
  int const width = s.width > 0 ? s.width : film.width, height = s.height > 0 ? s.height : film.height;
  s.width = std::max(width / scale, 1);
  s.height = std::max(height / scale, 1);
  s.photons =
      std::max<std::uint64_t>(s.photons / std::uint64_t(scale * scale), std::min<std::uint64_t>(s.photons, 512));
  if (s.causticShare == 0) s.causticShare = resolved.causticShare;
  s.radius = (s.radius > 0 ? s.radius : resolved.radius) * scale;
  s.causticRadius = (s.causticRadius > 0 ? s.causticRadius : resolved.caustic) * scale;
  return s;
}

void Estimate::install(std::unique_ptr<Integrator> next, const Target& target) {
  {
    std::lock_guard const lock(pixels_);
    std::swap(integrator, next);
    shown_.photonCount = 0;
    shown_.ready = false;
  }
  applied = target;
  scale = 1;
  settled = true;
  failed = false;
  problem.clear();
  fullSeconds_ = 0;
  clearMeasurements();
  if (!integrator) return;
  shown_.tree = integrator->tree();
  shown_.frameOrigin = integrator->frameOrigin();
  resolved_ = {stats_.firstRadius, stats_.firstCausticRadius, stats_.settings.causticShare};
  radiusFor_ = target;
}

bool Estimate::restart(const Target& target, const FilmDesc& film, int coarser, bool still) {
  if (target.scene != applied.scene) return false;
  Settings settings = target.settings;
  bool const sameRadius = target.settings.radius == applied.settings.radius &&
                          target.settings.causticRadius == applied.settings.causticRadius;
  if (coarser > 1)
    settings = draftOf(settings, film, coarser, sameRadius ? resolved_ : FirstRadii{});
  else if (target == radiusFor_ || (!still && sameRadius)) {
    if (settings.radius == 0) settings.radius = resolved_.radius;
    if (settings.causticRadius == 0) settings.causticRadius = resolved_.caustic;
    if (settings.causticShare == 0) settings.causticShare = resolved_.causticShare;
  }
  if (!integrator->restart(target.camera, settings)) return false;
  applied = target;
  scale = coarser;
  settled = coarser == 1 && still;
  clearMeasurements();
  if (settled) {
    resolved_ = {stats_.firstRadius, stats_.firstCausticRadius, stats_.settings.causticShare};
    radiusFor_ = target;
  }
  return true;
}

void Estimate::clearMeasurements() {
  curve_.clear();
  shown_.stages.clear();
  shown_.iterationSeconds = 0;
  shown_.errors.clear();
  shown_.slope = std::numeric_limits<double>::quiet_NaN();
  stats_ = integrator ? integrator->stats() : Stats{};
}

bool Estimate::advance(int count) {
  Stats const before = stats_;
  auto const start = std::chrono::steady_clock::now();
  bool const finished = integrator->advance(count);
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  clock += seconds;
  if (!finished) return false;
  stats_ = integrator->stats();
  shown_.iterationSeconds = seconds / count;
  if (scale == 1)
    fullSeconds_ = seconds / count;
  else if (fullSeconds_ == 0)
    fullSeconds_ = seconds / count * scale * scale;
  recordStages(before);
  return true;
}

void Estimate::reset() {
  integrator->reset();
  clearMeasurements();
}

void Estimate::recordStages(const Stats& before) {
  double const iterations = double(stats_.iterations - before.iterations);
  StageSample sample;
  for (const auto& [stage, seconds] : stats_.stageSeconds) {
    auto const earlier = before.stageSeconds.find(stage);
    double const spent = seconds - (earlier == before.stageSeconds.end() ? 0 : earlier->second);
    sample.emplace_back(stage, spent / iterations);
  }
  if (!sample.empty()) shown_.stages.push_back(std::move(sample));
  if (shown_.stages.size() > stageHistory) shown_.stages.pop_front();
}

void Estimate::present(std::uint32_t photons) {
  std::lock_guard const lock(pixels_);
  auto const start = std::chrono::steady_clock::now();
  shown_.ready = false;  // until the buffers that are copied from are whole
  shown_.photonCount = 0;
  shownPhotons = photons;
  if (!integrator->present()) return;
  shown_.presentSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  shown_.photonCount = photons > 0 ? integrator->presentPhotons(photons) : 0;
  shown_.width = stats_.settings.width;
  shown_.height = stats_.settings.height;
  shown_.pixelIterations = stats_.iterations;
  shown_.camera = applied.camera;
  ++shown_.pixelVersion;
  ++shown_.photonVersion;
  shown_.ready = true;
  shown_.draft = scale > 1;
}

int Estimate::batchFor(double seconds) const {
  if (!(shown_.iterationSeconds > 0)) return 1;
  return int(std::clamp(seconds / shown_.iterationSeconds, 1.0, 256.0));
}

int Estimate::scaleFor(double seconds) const {
  if (fullSeconds_ == 0) return integrator->gpu() < 0 ? 4 : 1;
  int coarser = 1;
  while (coarser < 8 && fullSeconds_ > seconds * coarser * coarser) coarser *= 2;
  return coarser;
}

void Estimate::measure(const Image* truth, std::uint64_t version) {
  measuredVersion = version;
  if (!truth) {
    curve_.clear();
    shown_.errors.clear();
    shown_.slope = std::numeric_limits<double>::quiet_NaN();
  }
  if (scale > 1 || !truth) return;
  if (curve_.due(stats_.seconds) && stats_.iterations > 0)
    curve_.add(stats_.seconds, double(stats_.iterations), integrator->film());
  curve_.measure(*truth, version);
  shown_.errors = curve_.points();
  shown_.slope = curve_.slope();
}

void Estimate::fill(EstimateStatus& status) const {
  status = shown_;
  status.stats = stats_;
  status.problem = problem;
}

bool Estimate::copyPixels(void* to, std::size_t capacity, int& width, int& height, std::uint64_t& iterations) {
  std::lock_guard const lock(pixels_);
  std::size_t const bytes = std::size_t(shown_.width) * std::size_t(shown_.height) * 4 * sizeof(float);
  if (!integrator || !shown_.ready || bytes > capacity) return false;
  try {
    integrator->copyPixels(to);
  } catch (const std::exception&) {  // the render thread runs into it too, and reports it
    return false;
  }
  width = shown_.width;
  height = shown_.height;
  iterations = shown_.pixelIterations;
  return true;
}

std::uint32_t Estimate::copyPhotons(PhotonPoint* to, std::uint32_t capacity) {
  std::lock_guard const lock(pixels_);
  std::uint32_t const count = std::min(shown_.photonCount, capacity);
  if (!integrator || count == 0) return 0;
  try {
    integrator->copyPhotons(to, count);
  } catch (const std::exception&) {
    return 0;
  }
  return count;
}

}  // namespace ropelight::view
