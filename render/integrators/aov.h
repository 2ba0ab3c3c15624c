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
    this->run(this->frame_.slots(), TraceAovArgs{this->frame_, kind(), this->radiance_.span()});
    this->commit();
  }

 private:
  Aov kind() const {
    const char* const names[] = {"normal", "depth", "albedo", "traversal", "tests"};
    for (int i = 0; i < 5; ++i)
      if (this->prepared_.settings.aov == names[i]) return Aov(i);
    return Aov::normal;
  }
};

}  // namespace ropelight::RL_TARGET
