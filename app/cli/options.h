#pragma once
// The command line: which subcommand it is for, and what that makes of it.

#include <span>
#include <string>

#include "app/subcommands/subcommands.h"

namespace ropelight {

/// What --help prints: a line for every subcommand.
std::string overview(std::span<const Subcommand* const> table = subcommands());

/// Reads the arguments, the program's name first. Throws Error (usage) naming the argument and what was expected.
Command parseCommandLine(int argc, const char* const* argv, std::span<const Subcommand* const> table = subcommands());

}  // namespace ropelight
