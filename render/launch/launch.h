#pragma once
// Starts a stage in the kernel row that covers the scene. Every stage x row x backend is a translation unit of its own,
// which CMake writes, so that drivers are compiled once a backend and no unit takes minutes.

#include <vector>

#include "render/backend/kernel_use.h"
#include "render/launch/rows.h"

namespace ropelight::RL_TARGET {

class Backend;

/// Calls Args::Stage<F> for elements [0, n). Defined in the generated units alone, for every row.
template <class Args, FeatureBits F>
void launchRow(Backend& backend, std::uint32_t n, const Args& args);

/// What that kernel takes of a GPU. Defined likewise.
template <class Args, FeatureBits F>
KernelUse kernelUse();

/// Appends those of every row.
template <class Args>
void addKernelUses(std::vector<KernelUse>& uses) {
  auto const add = [&](KernelUse use, const char* row) {
    use.row = row;
    uses.push_back(use);
  };
#ifdef ROPELIGHT_LAST_ROW_ONLY
#define RL_ADD_USE(name)
  add(kernelUse<Args, row::all>(), "all");
#else
#define RL_ADD_USE(name) add(kernelUse<Args, row::name>(), #name);
#endif
  RL_ROWS(RL_ADD_USE)
#undef RL_ADD_USE
}

/// Calls Args::Stage<F> for elements [0, n) in row `row` of kernelRows.
template <class Args>
void launch(Backend& backend, int row, std::uint32_t n, const Args& args) {
  using Launcher = void (*)(Backend&, std::uint32_t, const Args&);
#ifdef ROPELIGHT_LAST_ROW_ONLY  // it covers what the others do, and a build for checks compiles less
#define RL_LAUNCHER(name) launchRow<Args, row::all>,
#else
#define RL_LAUNCHER(name) launchRow<Args, row::name>,
#endif
  static constexpr Launcher launchers[] = {RL_ROWS(RL_LAUNCHER)};
#undef RL_LAUNCHER
  launchers[row](backend, n, args);
}

}  // namespace ropelight::RL_TARGET
