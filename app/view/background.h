#pragma once
// Threads that give way to the window: at a lower priority the interface stays fluent while all cores render.

#include <oneapi/tbb/task_scheduler_observer.h>

namespace ropelight::view {

/// Lowers the priority of the calling thread alone.
void giveWay();

/// While it lives, the scheduler's workers give way.
class WorkersGiveWay : public oneapi::tbb::task_scheduler_observer {
 public:
  WorkersGiveWay() { observe(true); }
  ~WorkersGiveWay() override { observe(false); }
  void on_scheduler_entry(bool worker) override {
    if (worker) giveWay();
  }
};

}  // namespace ropelight::view
