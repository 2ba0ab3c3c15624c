#include "render/integrators/integrator.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/backend/devices.h"
#include "render/core/error.h"
#include "render/prepare/prepare.h"

namespace ropelight {

// Each backend's are compiled apart; those in cuda are there only where it is built.
namespace cpu {
std::unique_ptr<Integrator> makePrepared(const Prepared& prepared);
}
namespace cpu64 {
std::unique_ptr<Integrator> makePrepared(const Prepared& prepared);
}
namespace cuda {
std::unique_ptr<Integrator> makePrepared(const Prepared& prepared);
std::vector<KernelUse> allKernelUses();
}  // namespace cuda

std::unique_ptr<Integrator> makeIntegrator(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                           std::string* why, std::shared_ptr<SceneCache> cache) {
  ChosenBackend const chosen = chooseBackend(choice);
  if (why) *why = chosen.why;
  BackendChoice resolvedChoice = choice;
  resolvedChoice.gpu = chosen.gpu;
  if (!cache) cache = makeSceneCache(scene);
  Prepared const prepared = prepare(scene, settings, resolvedChoice, chosen.cuda, *cache);
#if ROPELIGHT_CUDA
  if (chosen.cuda) return cuda::makePrepared(prepared);
#endif
  return chosen.inDouble ? cpu64::makePrepared(prepared) : cpu::makePrepared(prepared);
}

std::string nonFiniteStages(const Stats& stats) {
  std::string text;
  for (auto const& [stage, count] : stats.nonFiniteBy)
    text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", count, stage);
  return text;
}

std::vector<KernelUse> kernelUses(const BackendChoice& choice) {
  if (!chooseBackend(choice).cuda) return {};
#if ROPELIGHT_CUDA
  return cuda::allKernelUses();
#else
  return {};
#endif
}

}  // namespace ropelight
