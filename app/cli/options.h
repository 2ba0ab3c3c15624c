#pragma once
// The command line as checked values.

#include <string>
#include <variant>

#include "app/bench/bench.h"
#include "app/commands/compare.h"
#include "app/commands/devices.h"
#include "app/commands/info.h"
#include "app/commands/render.h"
#include "app/converge/converge.h"
#include "app/stress/stress.h"
#include "app/viewer/view.h"

namespace ropelight {

/// --help and --version: a text for standard output.
struct Message {
  std::string text;
};

using Command = std::variant<Message, ViewOptions, RenderOptions, InfoOptions, DevicesOptions, CompareOptions,
                             BenchOptions, StressOptions, ConvergeOptions>;

/// Reads the arguments, the program's name first. Throws Error (usage) naming the argument and what was expected.
Command parseCommandLine(int argc, const char* const* argv);

}  // namespace ropelight
