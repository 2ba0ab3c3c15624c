#pragma once
// A subcommand: its line in the overview, and how its arguments are read.

#include <functional>
#include <string>
#include <vector>

namespace ropelight {

/// What a command line asks for: returns the exit code.
using Command = std::function<int()>;

using Arguments = std::vector<std::string>;

struct Subcommand {
  const char* name;
  const char* arguments;  ///< as the overview shows them
  const char* doc;
  /// Reads the arguments that follow the name. Throws Error (usage) naming the argument and what was expected.
  Command (*parse)(const Subcommand& self, Arguments arguments);
};

}  // namespace ropelight
