#include "app/viewer/session/renderer.h"

#include <tuple>
#include <utility>

#include "app/viewer/session/render_thread.h"

namespace ropelight::view {
namespace {

/// Whether the settings that restart() cannot take differ.
bool needsAnother(const Settings& a, const Settings& b) {
  auto const key = [](const Settings& s) {
    return std::tie(s.mode, s.aov, s.accel, s.split, s.bins, s.leafSize, s.treeDepth);
  };
  return key(a) != key(b);
}

}  // namespace

Renderer::Renderer(const BackendChoice& choice, bool lockStep)
    : thread_(std::make_unique<RenderThread>(choice, lockStep)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(std::shared_ptr<const Scene> scene, const CameraDesc& camera) {
  thread_->change([&] {
    thread_->wanted.scene = std::move(scene);
    thread_->wanted.sceneCamera = camera;
    thread_->sceneProblem.clear();
    return true;
  });
}

void Renderer::setCamera(const CameraDesc& camera, std::uint64_t sceneVersion) {
  thread_->change([&] {
    if (sceneVersion != thread_->version || camera == thread_->wanted.camera) return false;
    thread_->wanted.camera = camera;
    thread_->wanted.changed = RenderThread::Clock::now();
    thread_->dropAccumulated();
    thread_->interruptAll();
    return true;
  });
}

void Renderer::setSettings(int which, const Settings& settings) {
  thread_->change([&] {
    Settings& wanted = thread_->wanted.settings[std::size_t(which)];
    if (wanted == settings) return false;
    bool const otherIntegrator = needsAnother(wanted, settings);
    wanted = settings;
    thread_->wanted.changed = RenderThread::Clock::now();
    if (!otherIntegrator) thread_->interrupt(which);  // else the present one continues until the other is ready
    return true;
  });
}

void Renderer::setEnabled(int which, bool enabled) {
  thread_->change([&] {
    bool& wanted = thread_->wanted.enabled[std::size_t(which)];
    if (wanted == enabled) return false;
    if (!enabled) thread_->interrupt(which);
    if (!enabled) thread_->steps[std::size_t(which)] = 0;
    wanted = enabled;
    if (which != reference) return true;
    ReferenceStatus& r = thread_->shownReference;
    if (enabled) r = {true, true, "accumulating", "", 0, nullptr, r.version + 1};
    if (enabled) thread_->nextReference = 1;
    r.accumulating = enabled;
    return true;
  });
}

void Renderer::setPaused(bool paused) {
  thread_->change([&] {
    if (thread_->wanted.paused == paused) return false;
    if (!paused && !thread_->inLockStep())
      for (auto& steps : thread_->steps) steps = 0;
    thread_->wanted.paused = paused;
    return true;
  });
}
void Renderer::setStageTimes(bool on) {
  thread_->change([&] { return std::exchange(thread_->wanted.stageTimes, on) != on; });
}
void Renderer::wantPhotons(std::uint32_t most) {
  thread_->change([&] { return std::exchange(thread_->wanted.photons, most) != most; });
}
void Renderer::reset() {
  thread_->change([&] {
    thread_->wanted.reset = true;
    thread_->interruptAll();
    return true;
  });
}

void Renderer::step(int n) {
  thread_->change([&] {
    for (int k = 0; k < RenderThread::count; ++k)
      thread_->steps[std::size_t(k)] += thread_->wanted.enabled[std::size_t(k)] ? n : 0;
    return true;
  });
}

void Renderer::finishSteps() { thread_->finishSteps(); }

void Renderer::setReference(std::shared_ptr<const Image> image, const std::string& name) {
  thread_->change([&] {
    thread_->wanted.enabled[reference] = false;
    thread_->shownReference = {true, false, name, "", 0, std::move(image), thread_->shownReference.version + 1};
    return true;
  });
}

void Renderer::clearReference() {
  thread_->change([&] {
    thread_->wanted.enabled[reference] = false;
    ReferenceStatus none;
    none.version = thread_->shownReference.version + 1;
    thread_->shownReference = none;
    return true;
  });
}

EstimateStatus Renderer::status(int which) const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->shown[std::size_t(which)];
}

ReferenceStatus Renderer::referenceStatus() const {
  std::lock_guard const lock(thread_->mutex);
  ReferenceStatus status = thread_->shownReference;
  const EstimateStatus& a = thread_->shown[estimateA];
  if (status.image && a.ready && !a.draft && (status.image->width != a.width || status.image->height != a.height))
    status.problem = "the reference is " + std::to_string(status.image->width) + " x " +
                     std::to_string(status.image->height) + ", the film " + std::to_string(a.width) + " x " +
                     std::to_string(a.height) + "; set the film's size to the reference's";
  return status;
}

std::shared_ptr<const Scene> Renderer::scene() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->scene;
}
std::uint64_t Renderer::sceneVersion() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->version;
}
std::string Renderer::problem() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->sceneProblem;
}
bool Renderer::busy() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->busy();
}
std::string Renderer::backendText() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->backendWhy;
}
int Renderer::gpu() const {
  std::lock_guard const lock(thread_->mutex);
  return thread_->gpuShown;
}

bool Renderer::copyPixels(int which, void* to, std::size_t capacity, int& width, int& height,
                          std::uint64_t& iterations) {
  return thread_->estimates[which].copyPixels(to, capacity, width, height, iterations);
}

std::uint32_t Renderer::copyPhotons(int which, PhotonPoint* to, std::uint32_t capacity) {
  return thread_->estimates[which].copyPhotons(to, capacity);
}

std::pair<Image, Stats> Renderer::film(int which) { return thread_->film(which); }

}  // namespace ropelight::view
