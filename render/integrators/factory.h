#pragma once
// One maker for every backend × mode × kernel row; each is instantiated in a translation unit of its own.

#include "render/integrators/integrator.h"
#include "render/kernels/variants.h"
#include "render/prepare/prepare.h"

namespace ropelight {

using Maker = std::unique_ptr<Integrator> (*)(const Prepared&);

/// The maker's name is make_<mode>_<row>; those in cuda are defined only where that backend is built.
#define RL_DECLARE(mode, row) std::unique_ptr<Integrator> make_##mode##_##row(const Prepared&);
#define RL_DECLARE_ROWS(mode) \
  RL_DECLARE(mode, basic) RL_DECLARE(mode, mesh) RL_DECLARE(mode, full) RL_DECLARE(mode, coincident)

namespace cpu {
RL_MODES(RL_DECLARE_ROWS)
}
namespace cuda {
RL_MODES(RL_DECLARE_ROWS)
}

}  // namespace ropelight
