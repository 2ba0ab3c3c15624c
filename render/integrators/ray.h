#pragma once
// `ray`: direct light and specular chains.

#include "render/integrators/base.h"
#include "render/kernels/trace_camera.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class RayIntegrator final : public IntegratorBase<Backend> {
 public:
  explicit RayIntegrator(const Prepared& p) : IntegratorBase<Backend>(p) {}

 protected:
  void iterate(std::uint64_t) override {
    this->run(this->frame_.slots(), TraceCameraArgs{this->frame_, this->radiance_.span(), {}, {}});
    this->commit();
  }
};

}  // namespace ropelight::RL_TARGET
