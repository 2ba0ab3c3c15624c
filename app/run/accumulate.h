#pragma once

#include "app/run/interrupt.h"
#include "app/run/progress.h"
#include "render/integrators/integrator.h"

namespace ropelight {

struct Accumulated {
  double seconds = 0;  ///< wall clock
  bool interrupted = false;
};

/// Advances until the goal is met or a signal asks to stop; at least one iteration, unless the integrator is
/// interrupted. Batches take about 0.1 s, so that both are honoured soon without a cost to every iteration.
Accumulated accumulate(Integrator& integrator, const Goal& goal, const StopOnSignal& stop, bool quiet);

}  // namespace ropelight
