#pragma once
// The renderer with a fault in it.

#include "render/core/hd.h"
#include "render/integrators/integrator.h"

namespace ropelight::testing {

/// makeIntegrator over a copy of the kernels in which `fault` is present as long as nothing else is asked for.
std::unique_ptr<Integrator> makeFaulty(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                       Fault fault);

}  // namespace ropelight::testing
