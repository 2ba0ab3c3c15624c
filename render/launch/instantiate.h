#pragma once
// The body of a generated translation unit, which has included its backend and its stage.

#include "render/launch/launch.h"

namespace ropelight::RL_TARGET {

template <class Args, FeatureBits F>
void launchRow(Backend& backend, std::uint32_t n, const Args& args) {
  backend.template forEach<row::blocks(Args::name, F)>(n, typename Args::template Stage<F>{args});
}

template <class Args, FeatureBits F>
KernelUse kernelUse() {
  return Backend::useOf<row::blocks(Args::name, F), typename Args::template Stage<F>>();
}

}  // namespace ropelight::RL_TARGET

#define RL_INSTANTIATE(stage, rowName)                                                                       \
  template void ropelight::RL_TARGET::launchRow<ropelight::RL_TARGET::stage##Args, ropelight::row::rowName>( \
      ropelight::RL_TARGET::Backend&, std::uint32_t, const ropelight::RL_TARGET::stage##Args&);              \
  template ropelight::KernelUse                                                                              \
  ropelight::RL_TARGET::kernelUse<ropelight::RL_TARGET::stage##Args, ropelight::row::rowName>();
