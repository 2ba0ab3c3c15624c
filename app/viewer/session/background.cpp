#include "app/viewer/session/background.h"

#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>
#include <unistd.h>

namespace ropelight::view {
namespace {

class WorkersGiveWay : public oneapi::tbb::task_scheduler_observer {
 public:
  WorkersGiveWay() { observe(true); }
  void on_scheduler_entry(bool worker) override {
    if (worker) giveWay();
  }
};

}  // namespace

/// One for the program, never destroyed: the scheduler keeps memory for every observer that was ever made.
void workersGiveWay() {
  static WorkersGiveWay* volatile const observer = new WorkersGiveWay;  // volatile: kept, so that it is no leak
  (void)observer;
}

void giveWay() {
  constexpr int nice = 10;
  setpriority(PRIO_PROCESS, id_t(gettid()), nice);  // on Linux the priority is a thread's own
}

}  // namespace ropelight::view
