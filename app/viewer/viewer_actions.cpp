// What panel and keys asked for in a frame.

#include <fmt/format.h>
#include <imgui.h>

#include <exception>

#include "app/run/output.h"
#include "app/viewer/camera/pick.h"
#include "app/viewer/viewer.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/image_files/image_file.h"

namespace ropelight::view {

void Viewer::open(const std::string& file) {
  if (!isImageFile(file)) {
    problem_.clear();
    return loader_.start(file, false);
  }
  attempt(fmt::format("reference: {}", file), [&] {
    renderer_.setReference(std::make_shared<const Image>(readImage(file)), file);
    state_.compare.accumulateReference = false;
    problem_.clear();
  });
}

void Viewer::perform(const Actions& actions) {
  performCamera(actions);
  performFiles(actions);
  if (actions.reset) renderer_.reset();
  if (actions.steps > 0) renderer_.step(actions.steps);
  if (actions.clearReference) {
    state_.compare.accumulateReference = false;
    renderer_.clearReference();
  }
  if (actions.copySettingsToOther)
    state_.settings[std::size_t(1 - state_.edited)] = state_.settings[std::size_t(state_.edited)];
  if (actions.automaticRange && !fitRange(state_.tone, renderer_.film(state_.edited).first))
    notice_ = "there is no film to take the range from yet";
  if (actions.quit) done_ = true;
}

void Viewer::performCamera(const Actions& actions) {
  Rect const shown = picture_.pictureRect(0);
  double const aspect = shown.empty() ? 1 : double(shown.width) / shown.height;
  if (actions.resetCamera) camera_.reset();
  if (actions.frameAll && scene_) camera_.frame(sceneBounds(*scene_), aspect);
  if (actions.frameSelection && scene_)
    camera_.frame(controls_.selection() >= 0 ? shapeBounds(*scene_, controls_.selection()) : sceneBounds(*scene_),
                  aspect);
  if (actions.saveView) {
    camera_.views.push_back({fmt::format("view {}", camera_.views.size() + 1), camera_.camera()});
    notice_ = fmt::format("kept as {}", camera_.views.back().name);
  }
  if (actions.restoreView && *actions.restoreView < int(camera_.views.size()))
    camera_.setCamera(camera_.views[std::size_t(*actions.restoreView)].camera);
  if (actions.copyCamera) {
    ImGui::SetClipboardText(cameraJson(camera_.camera()).c_str());
    notice_ = "the camera is in the clipboard, as scene JSON";
  }
}

void Viewer::performFiles(const Actions& actions) {
  for (const std::string& file : actions.open) open(file);
  const EstimateStatus& edited = estimates_[std::size_t(state_.edited)];
  auto const named = [&](const std::string& given, const char* extension) {
    return given != "*" || !scene_ ? given : pictureName(*scene_, edited.stats, extension);
  };
  std::string saved;
  for (const auto& [given, extension] : {std::pair(actions.savePng, ".png"), std::pair(actions.saveExr, ".exr")}) {
    if (given.empty()) continue;
    std::string const file = named(given, extension);
    saved += (saved.empty() ? "saved " : ", ") + file;
    attempt(saved, [&, &path = file] {
      requireNoInput(path, inputs());
      savePicture(path, renderer_, state_.edited, state_.tone);
    });
  }
  if (!actions.saveCamera.empty())
    attempt("saved " + actions.saveCamera, [&] {
      requireNoInput(actions.saveCamera, inputs());
      writeFile(actions.saveCamera, cameraJson(camera_.camera()) + "\n");
    });
  if (!actions.saveSettings.empty())
    attempt("saved " + actions.saveSettings, [&] {
      requireNoInput(actions.saveSettings, inputs());
      saveSettings(actions.saveSettings, state_.settings[std::size_t(state_.edited)]);
    });
  if (!actions.screenshot.empty()) screenshots_.push_back(named(actions.screenshot, "-window.png"));
}

}  // namespace ropelight::view
