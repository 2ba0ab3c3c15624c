#include "app/view/background.h"

#include <sys/resource.h>
#include <unistd.h>

namespace ropelight::view {

void giveWay() {
  constexpr int nice = 10;
  setpriority(PRIO_PROCESS, id_t(gettid()), nice);  // on Linux the priority is a thread's own
}

}  // namespace ropelight::view
