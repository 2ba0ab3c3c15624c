#pragma once
// The integrators of one backend, by kind: a new one is its file, an include and a line here.

#include "render/core/error.h"
#include "render/integrators/aov.h"
#include "render/integrators/path.h"
#include "render/integrators/ray.h"
#include "render/integrators/sppm.h"
#include "render/launch/stages.h"

namespace ropelight::RL_TARGET {

template <template <class> class Kind>
std::unique_ptr<Integrator> make(const Prepared& prepared) {
  return std::make_unique<Kind<Backend>>(prepared);
}

struct IntegratorMaker {
  IntegratorKind kind;
  std::unique_ptr<Integrator> (*make)(const Prepared&);
};

inline constexpr IntegratorMaker integratorMakers[] = {
    {IntegratorKind::ray, make<RayIntegrator>},
    {IntegratorKind::path, make<PathIntegrator>},
    {IntegratorKind::sppm, make<SppmIntegrator>},
    {IntegratorKind::aov, make<AovIntegrator>},
};

/// The integrator that the settings ask for.
std::unique_ptr<Integrator> makePrepared(const Prepared& prepared) {
  for (const IntegratorMaker& maker : integratorMakers)
    if (integratorOf(prepared.settings) == maker.kind) return maker.make(prepared);
  throw Error("this mode has no integrator", ExitCode::internal);
}

/// What every kernel of every row takes of a GPU.
std::vector<KernelUse> allKernelUses() {
  std::vector<KernelUse> uses;
#define RL_ADD_STAGE(stage, header) addKernelUses<stage##Args>(uses);
  RL_STAGES(RL_ADD_STAGE)
#undef RL_ADD_STAGE
  return uses;
}

}  // namespace ropelight::RL_TARGET
