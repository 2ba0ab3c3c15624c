#include "app/arguments/scene_arguments.h"

#include <fmt/format.h>

#include <type_traits>

#include "app/arguments/assign_setting.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

constexpr const char* settingsGroup = "Settings";

/// key=value, as -D takes it.
void assignPair(Settings& settings, const std::string& pair) {
  std::size_t const equals = pair.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("-D {}: expected key=value", pair), ExitCode::usage);
  assignSetting(settings, pair.substr(0, equals), pair.substr(equals + 1));
}

void addSettings(CLI::App& app, Settings& settings) {
  settings.params([&](const std::string& name, auto& value, const ParamInfo& info) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>)
      app.add_flag("--" + name, value, describe(info))->group(settingsGroup);
    else
      addValue(app, "--" + name, value, info)->group(settingsGroup);
  });
  auto const assignAll = [&settings](const std::vector<std::string>& pairs) {
    for (const std::string& pair : pairs) assignPair(settings, pair);
  };
  app.add_option_function<std::vector<std::string>>("-D", assignAll, "any setting as key=value, over its own option")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->group(settingsGroup);
}

}  // namespace

void addBackendArguments(CLI::App& app, BackendChoice& backend) {
  addValue(app, "--backend", backend.backend, ParamInfo{.doc = "what computes", .choices = choicesOf<BackendKind>});
  addValue(app, "--gpu", backend.gpu, ParamInfo{"index of the GPU; -1: the first usable one", -1, 1023});
  addValue(app, "--threads", backend.threads, ParamInfo{"CPU threads; 0: all cores", 0, 4096});
}

void addSceneArguments(CLI::App& app, SceneOptions& options) {
  addBackendArguments(app, options.backend);
  addSettings(app, options.settings);
}

}  // namespace ropelight
