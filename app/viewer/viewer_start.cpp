// What the main loop begins with: options that were checked before a window opens, preferences, the first scene.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/arguments/scene_path.h"
#include "app/run/output.h"
#include "app/viewer/viewer.h"
#include "render/backend/devices.h"
#include "render/core/error.h"
#include "render/import/load.h"

namespace ropelight::view {
namespace {

Size sizeOf(const ViewOptions& options, const Preferences& preferences) {
  if (options.window.empty()) return {preferences.width, preferences.height};
  Size size;
  const std::string& text = options.window;
  const char* const end = text.data() + text.size();
  auto const [x, first] = std::from_chars(text.data(), end, size.width);
  bool const cross = first == std::errc{} && x != end && *x == 'x';
  auto const [stop, second] = cross ? std::from_chars(x + 1, end, size.height) : std::from_chars_result{end, {}};
  if (!cross || second != std::errc{} || stop != end || std::min(size.width, size.height) < 1 ||
      std::max(size.width, size.height) > 16384)
    throw Error(fmt::format("--window: '{}' is no size such as 1280x800", text), ExitCode::usage);
  return size;
}

std::filesystem::path preferencesPath(const ViewOptions& options) {
  return options.noPreferences || options.frames > 0 ? std::filesystem::path{} : preferencesFile();
}

/// Everything that can be known to fail before a window opens.
ViewOptions checked(ViewOptions options) {
  options.scene.scene = findScene(options.scene.scene);
  requireOutputs({options.screenshot, options.state}, {options.scene.scene, options.reference, options.script});
  chooseBackend(options.scene.backend);
  return options;
}

int gpuOf(const BackendChoice& choice) {
  ChosenBackend const chosen = chooseBackend(choice);
  return chosen.cuda ? chosen.gpu : -1;
}

/// The scene, where no output would overwrite one of its files.
std::shared_ptr<const Scene> loadFirstScene(const ViewOptions& options, const std::filesystem::path& preferences) {
  auto scene = std::make_shared<const Scene>(loadScene(options.scene.scene));
  std::vector<std::string> inputs = filesOf(*scene);
  inputs.insert(inputs.end(), {options.reference, options.script, preferences.string()});
  requireOutputs({options.screenshot, options.state}, inputs);
  return scene;
}

/// The script, where no command of it would overwrite what is read. It may write a file of its own again.
std::optional<Script> loadScript(const ViewOptions& options, const Scene& scene) {
  if (options.script.empty()) return {};
  Script script = Script::load(options.script);
  std::vector<std::string> inputs = filesOf(scene);
  inputs.insert(inputs.end(), {options.reference, options.script});
  for (const std::string& file : script.outputs()) requireNoInput(file, inputs);
  return script;
}

Preferences initialPreferences(const std::filesystem::path& file, std::string& problem) {
  return file.empty() ? Preferences{} : loadPreferences(file, problem);
}

}  // namespace

Viewer::Viewer(const ViewOptions& options)
    : options_(checked(options)),
      lockStep_(options.frames > 0),
      preferencesFile_(preferencesPath(options)),
      comingScene_(loadFirstScene(options_, preferencesFile_)),
      script_(loadScript(options_, *comingScene_)),
      preferences_(initialPreferences(preferencesFile_, problem_)),
      state_(preferences_.state),
      window_("ropelight", sizeOf(options, preferences_).width, sizeOf(options, preferences_).height),
      gui_(window_, window_.contentScale() * float(options.uiScale)),
      renderer_(options_.scene.backend, lockStep_),
      picture_(gpuOf(options.scene.backend), !options.noInterop) {
  state_.settings = {options_.scene.settings, options_.scene.settings};
  camera_.views = preferences_.views;
  camera_.speed = preferences_.speed;
  renderer_.setSettings(estimateA, state_.settings[estimateA]);
  if (!options_.reference.empty()) open(options_.reference);
  if (!problem_.empty() && !options_.reference.empty() && !renderer_.referenceStatus().present) throw Error(problem_);
  renderer_.setScene(comingScene_, comingScene_->camera);
  watch_.start(*comingScene_);
  window_.setVsync(!lockStep_);
  started_ = frameStart_ = lastInput_ = Clock::now();
}

}  // namespace ropelight::view
