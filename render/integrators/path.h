#pragma once
// `path`: unidirectional path tracing.

#include "render/integrators/base.h"
#include "render/kernels/trace_path.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class PathIntegrator final : public IntegratorBase<Backend> {
 public:
  explicit PathIntegrator(const Prepared& p) : IntegratorBase<Backend>(p) {}

 protected:
  void iterate(std::uint64_t) override {
    this->run(this->frame_.slots(), TracePathArgs{this->frame_, this->radiance_.span()});
    this->commit();
  }
};

}  // namespace ropelight::RL_TARGET
