#pragma once
// The command line as checked values.

#include <string>
#include <variant>

#include "app/bench.h"
#include "app/compare.h"
#include "app/converge.h"
#include "app/devices.h"
#include "app/info.h"
#include "app/render.h"
#include "app/stress.h"
#include "app/view.h"

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
