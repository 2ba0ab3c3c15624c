#pragma once
// The body of a generated translation unit, which has included its backend: one maker.

#include "render/core/error.h"
#include "render/integrator/aov.h"
#include "render/integrator/factory.h"
#include "render/integrator/path.h"
#include "render/integrator/ray.h"
#include "render/integrator/sppm.h"

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
