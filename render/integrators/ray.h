#pragma once
// `ray`: direct light and specular chains.

#include "render/integrators/base.h"
#include "render/kernels/trace_camera.h"

namespace ropelight::RL_TARGET {

template <class Backend, FeatureBits F>
class RayIntegrator final : public IntegratorBase<Backend> {
 public:
  explicit RayIntegrator(const Prepared& p) : IntegratorBase<Backend>(p) {}

 protected:
  void iterate(std::uint64_t) override {
    this->backend_.forEach(this->frame_.slots(), TraceCamera<F>{this->frame_, this->radiance_.span(), {}});
    this->commit();
  }
};

}  // namespace ropelight::RL_TARGET
