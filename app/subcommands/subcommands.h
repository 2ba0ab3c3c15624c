#pragma once
// The list of subcommands. A new one is its own file, which defines NAMECommand, and one word here.

#include <span>

#include "app/subcommands/subcommand.h"

#define RL_SUBCOMMANDS(X) X(view) X(render) X(info) X(devices) X(compare) X(bench) X(converge) X(stress)

namespace ropelight {

#define RL_SUBCOMMAND(name) extern const Subcommand name##Command;
RL_SUBCOMMANDS(RL_SUBCOMMAND)
#undef RL_SUBCOMMAND

/// Those there are, in the order of the overview. A line that names none is for the first.
inline std::span<const Subcommand* const> subcommands() {
#define RL_SUBCOMMAND(name) &name##Command,
  static constexpr const Subcommand* table[] = {RL_SUBCOMMANDS(RL_SUBCOMMAND)};
#undef RL_SUBCOMMAND
  return table;
}

}  // namespace ropelight
