#define ROPELIGHT_TEST_TARGET cpu_faults
#define RL_FAULTS 1
#ifndef ROPELIGHT_LAST_ROW_ONLY
#define ROPELIGHT_LAST_ROW_ONLY 1
#endif
#include "render/backend/cpu_backend.h"
// the drivers, on that backend:
#include "render/integrators/modes.h"
#include "render/prepare/scene_cache.h"
#include "tests/stress/faulty_integrators.h"

namespace ropelight::cpu_faults {

Fault presentFault = Fault::none;
DeviceInfo Backend::device() const { return cpuDevice(threads()); }

}  // namespace ropelight::cpu_faults

namespace ropelight::testing {

std::unique_ptr<Integrator> makeFaulty(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                       Fault fault) {
  cpu_faults::presentFault = fault;
  return cpu_faults::makePrepared(prepare(scene, settings, choice, false, *makeSceneCache(scene)));
}

}  // namespace ropelight::testing
