#pragma once
// `aov`: the first hit's normal, depth, albedo and what finding it cost.

#include "render/integrators/base.h"
#include "render/kernels/trace_aov.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class AovIntegrator final : public IntegratorBase<Backend> {
 public:
  explicit AovIntegrator(const Prepared& p) : IntegratorBase<Backend>(p) {}

 protected:
  void iterate(std::uint64_t) override {
    this->run(this->frame_.slots(), TraceAovArgs{this->frame_, this->prepared_.settings.aov, this->radiance_.span()});
    this->commit();
  }
};

}  // namespace ropelight::RL_TARGET
