#include "app/viewer/session/render_thread.h"

#include <algorithm>
#include <exception>
#include <new>

#include "render/core/error.h"

namespace ropelight::view {
namespace {

constexpr double batchSeconds = 0.008;  ///< of iterations in a row: what is shown is as fresh as a frame
constexpr double draftSeconds = 0.030;  ///< an iteration may take while the camera moves
constexpr double stillSeconds = 0.25;   ///< after the latest change, until full size is taken again

const char* const noMemory = "out of memory; use a smaller film or fewer photons";

}  // namespace

RenderThread::RenderThread(const BackendChoice& choice, bool lockStep) : backend_(choice), lockStep_(lockStep) {
  thread_ = std::thread([this] { run(); });
}

RenderThread::~RenderThread() {
  {
    std::lock_guard const lock(mutex);
    quit_ = true;
    interruptAll();
  }
  wake.notify_all();
  thread_.join();
}

void RenderThread::interrupt(int k) {
  if (Integrator* const running = interruptible_[std::size_t(k)]) running->interrupt();
}

void RenderThread::interruptAll() {
  for (int k = 0; k < count; ++k) interrupt(k);
}

void RenderThread::finishSteps() {
  std::unique_lock lock(mutex);
  idle.wait(lock, [&] { return answered == asked; });
}

std::pair<Image, Stats> RenderThread::film(int which) {
  std::unique_lock lock(mutex);
  filmAsked_ = which;
  ++asked;
  wake.notify_all();
  idle.wait(lock, [&] { return filmAsked_ < 0; });
  return std::move(filmAnswer_);
}

void RenderThread::run() {
  giveWay();
  workersGiveWay();
  std::unique_lock lock(mutex);
  while (!quit_) {
    std::uint64_t const seen = asked;
    Wanted const now = wanted;
    wanted.reset = false;
    lock.unlock();
    bool const worked = guardedTurn(now);
    lock.lock();
    publish(now);
    published = seen;
    serveFilm();
    if (worked || quit_ || asked != seen) continue;
    bool const done = !builder_.busy() && settled(now);
    if (done) answered = seen;
    idle.notify_all();
    wake.wait_for(lock, std::chrono::milliseconds(done ? 50 : 5), [&] { return quit_ || asked != seen; });
  }
}

bool RenderThread::settled(const Wanted& now) const {
  for (int k = 0; k < count; ++k)
    if (now.enabled[std::size_t(k)] && estimates[k].integrator && !estimates[k].settled) return false;
  return true;
}

/// Whether an estimate still differs from what is wanted.
bool RenderThread::pending(int k, const Wanted& now) const {
  const Estimate& e = estimates[k];
  if (!now.enabled[std::size_t(k)] || !scene || e.failed) return false;
  Target const target = targetOf(k, now);
  return refused_[std::size_t(k)] != target && (!e.integrator || !e.settled || e.applied != target);
}

/// An unexpected exception ends the estimates, not the program.
bool RenderThread::guardedTurn(const Wanted& now) {
  try {
    return turn(now);
  } catch (const std::exception& error) {
    for (Estimate& e : estimates) {
      e.failed = true;
      e.problem = error.what();
    }
    return false;
  }
}

/// One round of work; false where there was nothing to do.
bool RenderThread::turn(const Wanted& now) {
  if (takeBuilt(now)) {  // the camera may be another scene's now
    std::lock_guard const lock(mutex);
    wanted.reset = wanted.reset || now.reset;
    return true;
  }
  bool worked = false;
  if (now.scene && !builder_.busy()) orderScene(now);
  for (int k = 0; k < count; ++k) apply(k, now);
  int const next = mostInArrears(now);
  if (next >= 0) {
    advance(next, now);
    worked = true;
  }
  for (int k : {estimateA, estimateB}) worked = refresh(k, now) || worked;
  return worked;
}

void RenderThread::orderScene(const Wanted& now) {
  Order order{now.scene, nullptr, backend_, now.stageTimes, {}};
  for (int k = 0; k < count; ++k)
    if (now.enabled[std::size_t(k)])
      order.items.push_back({k, {version + 1, now.sceneCamera, now.settings[std::size_t(k)]}});
  builder_.start(std::move(order));
  std::lock_guard const lock(mutex);
  if (wanted.scene == now.scene) wanted.scene = nullptr;
}

void RenderThread::order(int k, const Target& target, const Wanted& now) {
  if (builder_.busy() || now.scene || refused_[std::size_t(k)] == target) return;
  builder_.start({scene, cache_, backend_, now.stageTimes, {{k, target}}});
}

bool RenderThread::takeBuilt(const Wanted& now) {
  std::optional<Built> built = builder_.take();
  if (!built) return false;
  bool const newScene = built->order.scene != scene;
  if (newScene && !built->problem.empty()) {
    std::lock_guard const lock(mutex);
    sceneProblem = built->problem;
    return true;
  }
  if (newScene) takeScene(*built);
  for (std::size_t i = 0; i < built->order.items.size(); ++i) {
    const Order::Item& item = built->order.items[i];
    if (!built->integrators[i]) {
      refuse(item.which, item.target, built->problems[i]);
      continue;
    }
    double const clock = leastClock(now);
    install(item.which, std::move(built->integrators[i]), item.target);
    begin(item.which, now, clock);
  }
  return true;
}

/// A new integrator starts with the clock of the one that had least time. On a CPU its first picture is a draft, so
/// that it comes soon and shows how long an iteration takes.
void RenderThread::begin(int k, const Wanted& now, double clock) {
  Estimate& e = estimates[k];
  e.clock = clock;
  if (lockStep_) return;
  if (e.scaleFor(draftSeconds) > 1) e.settled = false;
  if (now.paused && steps[std::size_t(k)] == 0) steps[std::size_t(k)] = 1;
}

void RenderThread::takeScene(const Built& built) {
  for (int k = 0; k < count; ++k) install(k, nullptr, {});
  std::lock_guard const lock(mutex);
  scene = built.order.scene;
  cache_ = built.order.cache;
  ++version;
  wanted.camera = built.order.items.empty() ? scene->camera : built.order.items[0].target.camera;
  sceneProblem.clear();
  backendWhy = built.backendText;
  nextReference = 1;
  dropAccumulated();
}

void RenderThread::install(int k, std::unique_ptr<Integrator> integrator, const Target& target) {
  {
    std::lock_guard const lock(mutex);
    interruptible_[std::size_t(k)] = nullptr;
  }
  broken_[std::size_t(k)] = false;
  estimates[k].install(std::move(integrator), target);
}

/// The settings stay as they were; the reason is shown.
void RenderThread::refuse(int k, const Target& target, const std::string& problem) {
  estimates[k].problem = problem;
  refused_[std::size_t(k)] = target;
}

bool RenderThread::draftWanted(int k) const { return !lockStep_ && estimates[k].unmeasured(); }

Target RenderThread::targetOf(int k, const Wanted& now) const {
  return {version, now.camera, now.settings[std::size_t(k)]};
}

/// Brings an estimate to what is wanted: nothing, a restart, or an order for another integrator.
void RenderThread::apply(int k, const Wanted& now) {
  Estimate& e = estimates[k];
  if (!now.enabled[std::size_t(k)]) {
    if (e.integrator) refused_ = {};  // there may be room now
    if (e.integrator) install(k, nullptr, {});
    return;
  }
  if (!scene) return;
  Target const target = targetOf(k, now);
  if (!e.integrator) return order(k, target, now);
  bool const moving = !lockStep_ && Clock::now() - now.changed < std::chrono::duration<double>(stillSeconds);
  int const scale = moving || draftWanted(k) ? e.scaleFor(draftSeconds) : 1;
  bool const same = e.applied == target && (e.settled || moving) && !broken_[std::size_t(k)] && !now.reset;
  if (same) {
    if (!e.failed) e.problem.clear();
    return;
  }
  if (refused_[std::size_t(k)] == target) {
    if (broken_[std::size_t(k)] || now.reset) e.reset();
    broken_[std::size_t(k)] = false;
    return;
  }
  restart(k, target, now, scale, !moving && scale == 1);
}

void RenderThread::restart(int k, const Target& target, const Wanted& now, int scale, bool still) {
  Estimate& e = estimates[k];
  {
    std::lock_guard const lock(mutex);
    interruptible_[std::size_t(k)] = nullptr;
  }
  try {
    if (!e.restart(target, scene->film, scale, still)) return order(k, target, now);
    broken_[std::size_t(k)] = false;
    e.problem.clear();
    if (e.failed) e.clock = std::max(e.clock, leastClock(now));
    e.failed = false;
    if (now.paused && !lockStep_ && steps[std::size_t(k)] == 0) steps[std::size_t(k)] = 1;
  } catch (const std::bad_alloc&) {
    install(k, nullptr, {});
    refuse(k, target, noMemory);
  } catch (const Error& error) {
    refuse(k, target, error.what());
    if (error.code() == ExitCode::usage) return keepSettings(k, now);
    install(k, nullptr, {});  // half-way through
    refuse(k, target, error.what());
  }
}

/// Where settings cannot be used, the old ones continue with the new camera.
void RenderThread::keepSettings(int k, const Wanted& now) {
  Estimate& e = estimates[k];
  broken_[std::size_t(k)] = false;
  if (!e.restart({version, now.camera, e.applied.settings}, scene->film, 1, true)) e.reset();
}

double RenderThread::leastClock(const Wanted& now) const {
  double least = 1e300;
  for (int k = 0; k < count; ++k)
    if (now.enabled[std::size_t(k)] && estimates[k].integrator) least = std::min(least, estimates[k].clock);
  return least == 1e300 ? 0 : least;
}

/// The estimate that has had the least of the machine's time among those that may go on; −1: none.
int RenderThread::mostInArrears(const Wanted& now) const {
  int next = -1;
  for (int k = 0; k < count; ++k) {
    const Estimate& e = estimates[k];
    Target const target = targetOf(k, now);
    bool const stepWanted = steps[std::size_t(k)] > 0 && (e.applied == target || refused_[std::size_t(k)] == target);
    bool const goesOn = now.enabled[std::size_t(k)] && e.integrator && !e.failed && !broken_[std::size_t(k)] &&
                        (stepWanted || (!now.paused && !lockStep_));
    if (goesOn && (next < 0 || e.clock < estimates[next].clock)) next = k;
  }
  return next;
}

void RenderThread::advance(int k, const Wanted& now) {
  Estimate& e = estimates[k];
  bool const stepping = now.paused || lockStep_;
  int const batch =
      stepping ? std::min<int>(steps[std::size_t(k)], e.batchFor(batchSeconds)) : e.batchFor(batchSeconds);
  {
    std::lock_guard const lock(mutex);
    if (quit_) return;
    bool const lasting = e.settled && !lockStep_;
    bool const outdated =
        wanted.reset || wanted.camera != now.camera || wanted.settings[std::size_t(k)] != now.settings[std::size_t(k)];
    if (lasting && outdated) return;
    interruptible_[std::size_t(k)] = lasting ? e.integrator.get() : nullptr;
  }
  try {
    e.integrator->timeStages(now.stageTimes);
    broken_[std::size_t(k)] = !e.advance(batch);
    if (broken_[std::size_t(k)]) return;
    if (stepping) steps[std::size_t(k)] -= batch;
    afterAdvance(k, now);
  } catch (const std::bad_alloc&) {
    e.problem = noMemory;
    e.failed = true;
  } catch (const std::exception& error) {
    e.problem = error.what();
    e.failed = true;
  }
}

}  // namespace ropelight::view
