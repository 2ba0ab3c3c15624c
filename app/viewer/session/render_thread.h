#pragma once
// The thread behind Renderer: brings every estimate to what is wanted and shares the machine's time among them.

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <thread>

#include "app/viewer/session/background.h"
#include "app/viewer/session/builder.h"
#include "app/viewer/session/estimate.h"

namespace ropelight::view {

class RenderThread {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int count = 3;

  /// What the window asked for.
  struct Wanted {
    CameraDesc camera;
    std::array<Settings, count> settings;
    std::array<bool, count> enabled{true, false, false};
    bool paused = false, stageTimes = false, reset = false;
    std::uint32_t photons = 0;
    Clock::time_point changed = Clock::now() - std::chrono::hours(1);
    std::shared_ptr<const Scene> scene;  ///< to be taken over; null: none
    CameraDesc sceneCamera;
  };

  RenderThread(const BackendChoice& choice, bool lockStep);
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// Changes what is wanted, under the mutex, and wakes the thread where apply() returns that something changed.
  template <class Change>
  void change(Change&& apply) {
    {
      std::lock_guard const lock(mutex);
      if (!apply()) return;
      ++asked;
    }
    wake.notify_all();
  }

  /// Under the mutex: whether anything asked for is still to come.
  bool busy() const { return busyShown || published != asked || wanted.scene; }

  /// Under the mutex: gives up a running iteration that is no longer wanted. Drafts are finished, so that something is
  /// shown.
  void interrupt(int k);
  void interruptAll();
  void dropAccumulated();
  bool inLockStep() const { return lockStep_; }

  /// As Renderer's.
  void finishSteps();
  std::pair<Image, Stats> film(int which);

  mutable std::mutex mutex;

  // What window and thread share, under the mutex.
  Wanted wanted;
  std::array<EstimateStatus, count> shown;
  ReferenceStatus shownReference;
  std::string sceneProblem, backendWhy;
  std::uint64_t nextReference = 1;  ///< iterations at which an accumulating reference is looked at next
  int gpuShown = -1;
  bool busyShown = false;
  std::shared_ptr<const Scene> scene;  ///< written by the thread alone
  std::uint64_t version = 0;           ///< the same

  std::array<std::atomic<int>, count> steps{};
  Estimate estimates[count];

 private:
  void run();
  bool guardedTurn(const Wanted& now);
  bool turn(const Wanted& now);
  bool settled(const Wanted& now) const;
  bool pending(int k, const Wanted& now) const;
  bool draftWanted(int k) const;
  Target targetOf(int k, const Wanted& now) const;

  void orderScene(const Wanted& now);
  void order(int k, const Target& target, const Wanted& now);
  bool takeBuilt(const Wanted& now);
  void takeScene(const Built& built);
  void install(int k, std::unique_ptr<Integrator> integrator, const Target& target);
  void begin(int k, const Wanted& now, double clock);
  void keepSettings(int k, const Wanted& now);
  void refuse(int k, const Target& target, const std::string& problem);

  void apply(int k, const Wanted& now);
  void restart(int k, const Target& target, const Wanted& now, int scale, bool still);
  int mostInArrears(const Wanted& now) const;
  double leastClock(const Wanted& now) const;
  void advance(int k, const Wanted& now);
  void afterAdvance(int k, const Wanted& now);
  void measure(Estimate& e);
  bool refresh(int k, const Wanted& now);
  void renewReference(Estimate& e);
  void publish(const Wanted& now);
  void serveFilm();

  BackendChoice const backend_;
  bool const lockStep_;
  std::condition_variable wake, idle;
  std::uint64_t asked = 0, answered = 0;
  std::uint64_t published = 0;  ///< the last request that the shown statuses cover
  std::array<Integrator*, count> interruptible_{};
  int filmAsked_ = -1;
  std::pair<Image, Stats> filmAnswer_;
  bool quit_ = false;

  // The thread's own.
  std::shared_ptr<SceneCache> cache_;
  std::array<bool, count> broken_{};     ///< interrupted: a restart must follow
  std::array<Target, count> refused_{};  ///< not to be tried again
  Builder builder_;
  std::thread thread_;
};

}  // namespace ropelight::view
