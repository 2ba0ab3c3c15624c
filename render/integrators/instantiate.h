#pragma once
// The body of a generated translation unit, which has included its backend: one maker.

#include "render/core/error.h"
#include "render/integrators/aov.h"
#include "render/integrators/factory.h"
#include "render/integrators/path.h"
#include "render/integrators/ray.h"
#include "render/integrators/sppm.h"

namespace ropelight::RL_TARGET {

template <FeatureBits F>
using Integrator_ray = RayIntegrator<Backend, F>;
template <FeatureBits F>
using Integrator_path = PathIntegrator<Backend, F>;
template <FeatureBits F>
using Integrator_sppm = SppmIntegrator<Backend, F>;
template <FeatureBits F>
using Integrator_aov = AovIntegrator<Backend, F>;

}  // namespace ropelight::RL_TARGET

#define ROPELIGHT_INSTANTIATE(mode, rowName)                                      \
  namespace ropelight::RL_TARGET {                                                \
  std::unique_ptr<Integrator> make_##mode##_##rowName(const Prepared& prepared) { \
    return std::make_unique<Integrator_##mode<row::rowName>>(prepared);           \
  }                                                                               \
  }
