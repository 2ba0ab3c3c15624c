#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/arguments/scene_options.h"
#include "app/arguments/values.h"

namespace ropelight {

/// Adds `flags` as an option that parseValue checks; where it is repeated, the last one counts. `value` must outlive
/// the parse; it holds the default.
template <class T>
CLI::Option* addValue(CLI::App& app, const std::string& flags, T& value, const ParamInfo& info) {
  auto const assign = [flags, info, &value](const std::string& text) { parseValue(flags, text, info, value); };
  CLI::Option* const option = app.add_option_function<std::string>(flags, assign, describe(info));
  return option->type_name("")->take_last()->default_str(formatValue(value));
}

/// Adds --backend, --gpu and --threads.
void addBackendArguments(CLI::App& app, BackendChoice& backend);

/// Adds the scene's options: backend, GPU, threads, one option for every value of Settings::params, and -D.
void addSceneArguments(CLI::App& app, SceneOptions& options);

}  // namespace ropelight
