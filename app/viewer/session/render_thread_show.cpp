// What the render thread shows: pixels, photons, errors, statuses, the film.

#include <exception>

#include "app/viewer/session/render_thread.h"

namespace ropelight::view {

void RenderThread::afterAdvance(int k, const Wanted& now) {
  Estimate& e = estimates[k];
  e.present(k == reference ? 0 : now.photons);
  if (k == reference)
    renewReference(e);
  else
    measure(e);
}

void RenderThread::measure(Estimate& e) {
  std::shared_ptr<const Image> image;
  std::uint64_t imageVersion = 0;
  {
    std::lock_guard const lock(mutex);
    image = shownReference.image;
    imageVersion = shownReference.version;
  }
  e.measure(image.get(), imageVersion);
}

/// An estimate that is paused still shows what is newly asked for: photons, and errors against the reference.
bool RenderThread::refresh(int k, const Wanted& now) {
  Estimate& e = estimates[k];
  EstimateStatus const& s = shown[std::size_t(k)];
  if (!e.integrator || e.failed || broken_[std::size_t(k)] || s.pixelIterations == 0 || !e.presented()) return false;
  bool worked = false;
  if (e.shownPhotons != now.photons) {
    e.present(now.photons);
    worked = true;
  }
  std::uint64_t referenceVersion;
  {
    std::lock_guard const lock(mutex);
    referenceVersion = shownReference.version;
  }
  if (e.measuredVersion != referenceVersion) {
    measure(e);
    worked = true;
  }
  return worked;
}

/// An accumulating reference is read whenever its iterations have doubled.
void RenderThread::renewReference(Estimate& e) {
  EstimateStatus status;
  e.fill(status);
  std::uint64_t const iterations = status.stats.iterations;
  std::lock_guard const lock(mutex);
  shownReference.iterations = iterations;
  if (iterations == 1) nextReference = 1;
  if (iterations < nextReference || e.scale > 1 || !shownReference.accumulating) return;
  nextReference = 2 * iterations;
  shownReference.image = std::make_shared<const Image>(e.integrator->film());
  ++shownReference.version;
}

/// Under the mutex.
void RenderThread::publish(const Wanted& now) {
  for (int k = 0; k < count; ++k) {
    EstimateStatus& s = shown[std::size_t(k)];
    estimates[k].fill(s);
    s.enabled = wanted.enabled[std::size_t(k)];
    s.building = s.enabled && (builder_.busy() || wanted.scene != nullptr);
  }
  if (estimates[0].integrator) gpuShown = estimates[0].integrator->gpu();
  busyShown = builder_.busy();
  for (int k = 0; k < count; ++k) busyShown = busyShown || pending(k, now);
}

/// Under the mutex.
void RenderThread::serveFilm() {
  if (filmAsked_ < 0) return;
  const Estimate& e = estimates[filmAsked_];
  filmAnswer_ = {};
  try {
    if (e.integrator && !e.failed && !broken_[std::size_t(filmAsked_)] && e.scale == 1)
      filmAnswer_ = {e.integrator->film(), e.integrator->stats()};
  } catch (const std::exception&) {  // the estimate says so itself when it goes on
  }
  filmAsked_ = -1;
  idle.notify_all();
}

/// Under the mutex: an accumulating reference is of another picture now.
void RenderThread::dropAccumulated() {
  if (!shownReference.accumulating) return;
  shownReference.image = nullptr;
  shownReference.iterations = 0;
  ++shownReference.version;
  nextReference = 1;
}

}  // namespace ropelight::view
