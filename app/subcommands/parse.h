#pragma once
// What the files of the subcommands share.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "app/subcommands/subcommand.h"
#include "render/core/error.h"

namespace ropelight {

inline constexpr const char* jsonDoc = "write statistics as JSON; '-': standard output";

void addSceneName(CLI::App& app, std::string& scene);
CLI::Option* addFile(CLI::App& app, const char* flags, std::string& file, const char* doc);
/// Reads the arguments into what the app's options are bound to. False where help was asked for, and sets it.
bool parseInto(CLI::App& app, const Subcommand& self, Arguments arguments, std::string& help);
/// A command that prints the text.
Command printing(std::string text);

/// Reads the arguments into Options, whose options `declare` adds; the command calls run(options).
template <class Options, class Declare>
Command parse(const Subcommand& self, Arguments arguments, Declare declare, int (*run)(const Options&)) {
  Options options;
  CLI::App app(self.doc, fmt::format("ropelight {}", self.name));
  app.set_help_flag("-h,--help", "print this help");
  declare(app, options);
  std::string help;
  if (!parseInto(app, self, std::move(arguments), help)) return printing(std::move(help));
  return [options = std::move(options), run] { return run(options); };
}

}  // namespace ropelight
