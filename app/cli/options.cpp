#include "app/cli/options.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/version.h"
#include "app/subcommands/parse.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

/// A line that names no subcommand is for the first of them, unless its first word is a mistyped one.
Command parseDefault(const Subcommand& self, Arguments arguments) {
  std::string const first = arguments[0];
  try {
    return self.parse(self, std::move(arguments));
  } catch (const Error& error) {
    if (first[0] == '-') throw;
    throw Error(fmt::format("{} ('{}' is no subcommand and was taken for a scene)", error.what(), first), error.code());
  }
}

}  // namespace

std::string overview(std::span<const Subcommand* const> table) {
  std::string text = "ropelight: stochastic progressive photon mapping on the CPU and on CUDA\n\n";
  for (const Subcommand* s : table)
    text += fmt::format("  {:<38}{}\n", fmt::format("ropelight {} {}", s->name, s->arguments), s->doc);
  text += fmt::format("  {:<38}{}\n", "ropelight --version", "Print the version.");
  return text + "\nropelight SUBCOMMAND --help lists a subcommand's options.\n";
}

Command parseCommandLine(int argc, const char* const* argv, std::span<const Subcommand* const> table) {
  Arguments arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) throw Error("no scene and no subcommand; see ropelight --help", ExitCode::usage);
  if (arguments[0] == "--help" || arguments[0] == "-h") return printing(overview(table));
  if (arguments[0] == "--version") return printing(fmt::format("ropelight {}\n", version));
  for (const Subcommand* s : table)
    if (arguments[0] == s->name) return s->parse(*s, {arguments.begin() + 1, arguments.end()});
  return parseDefault(*table.front(), std::move(arguments));
}

}  // namespace ropelight
