#include "app/viewer/viewer.h"

#include <GL/glew.h>
#include <fmt/format.h>

#include <algorithm>

#include "app/run/output.h"
#include "app/run/standard_streams.h"
#include "app/viewer/camera/pick.h"
#include "render/core/error.h"

namespace ropelight::view {
namespace {

constexpr float panelWidth = 404;      ///< at scale 1
constexpr double matchPatience = 0.3;  ///< seconds that the window's size must hold

}  // namespace

Viewer::~Viewer() = default;

std::vector<std::string> Viewer::inputs() const {
  std::vector<std::string> files = filesOf(scene_ ? *scene_ : *comingScene_);
  files.insert(files.end(), {options_.reference, options_.script});
  return files;
}

int Viewer::run() {
  while (!done_) {
    takeScenes();
    if (frameWanted()) {
      takeInput();
      drawInterface();
      tellRenderer();
      drawPicture();
      finishFrame();
    }
    pace();
    if (window_.shouldClose() || stop_.requested()) done_ = true;
  }
  if (options_.frames == 0 && !options_.state.empty()) writeState(options_.state);
  end();
  if (script_ && !script_->problem().empty()) throw Error(script_->problem(), ExitCode::internal);
  return int(ExitCode::done);
}

/// Scenes that were read go to the renderer; the one that it shows decides camera and names.
void Viewer::takeScenes() {
  if (auto loaded = loader_.take()) {
    if (!loaded->scene) {
      problem_ = loaded->problem;
    } else {
      bool const sameView = loaded->again && scene_ && scene_->camera == loaded->scene->camera;
      comingScene_ = loaded->scene;
      renderer_.setScene(comingScene_, sameView ? camera_.camera() : comingScene_->camera);
    }
  }
  if (options_.watch && scene_ && !loader_.busy() && watch_.changed(counts_.seconds)) loader_.start(scene_->file, true);
  if (std::string const why = renderer_.problem(); !why.empty()) problem_ = why;
  for (int k = 0; k < 3; ++k) estimates_[std::size_t(k)] = renderer_.status(k);
  if (renderer_.sceneVersion() != sceneVersion_) takeScene();
}

void Viewer::takeScene() {
  bool const again = scene_ && scene_->file == renderer_.scene()->file;
  bool const sameView = again && scene_->camera == renderer_.scene()->camera;
  scene_ = renderer_.scene();
  sceneVersion_ = renderer_.sceneVersion();
  CameraDesc const before = camera_.camera();
  camera_.setHome(scene_->camera, sceneBounds(*scene_));
  if (sameView) {
    camera_.setCamera(before);
    renderer_.setCamera(before, sceneVersion_);
  }
  toldCamera_ = camera_.camera();
  controls_.clearSelection();
  watch_.start(*scene_);
  ++counts_.scenes;
  std::erase(state_.recent, scene_->file);
  state_.recent.insert(state_.recent.begin(), scene_->file);
  if (state_.recent.size() > 12) state_.recent.resize(12);
  if (counts_.scenes > 1) {
    notice_ = fmt::format("{} {}", again ? "loaded again:" : "opened", scene_->file);
    problem_.clear();
  }
}

void Viewer::drawInterface() {
  gui_.begin();
  PanelContext panel = context();
  drawPanel(panel, panelWidth * gui_.scale());
  Size const fb = window_.framebufferSize(), size = window_.windowSize();
  double const ratio = size.width > 0 ? double(fb.width) / size.width : 1;
  controls_.apply({state_, camera_, actions_, picture_, scene_.get(), ratio, frameSeconds_, viewScale()});
  if (!controls_.notice().empty()) notice_ = controls_.notice();
}

void Viewer::tellRenderer() {
  matchWindow();
  for (int k : {estimateA, estimateB}) renderer_.setSettings(k, state_.settings[std::size_t(k)]);
  Settings truth = state_.settings[estimateA];
  truth = Settings{.mode = Mode::path,
                   .aov = sourceOf(truth.aov) == AovSource::gather ? Aov::radiance : truth.aov,
                   .width = truth.width,
                   .height = truth.height,
                   .maxDepth = truth.maxDepth,
                   .seed = truth.seed + 7919,
                   .indirectOnly = truth.indirectOnly};
  renderer_.setSettings(reference, truth);
  renderer_.setEnabled(estimateB, state_.compare.enabled);
  ReferenceStatus const status = renderer_.referenceStatus();
  if (state_.compare.accumulateReference != status.accumulating)
    renderer_.setEnabled(reference, state_.compare.accumulateReference);
  renderer_.setPaused(state_.paused);
  renderer_.setStageTimes(state_.stageTimes);
  renderer_.wantPhotons(state_.photons.shown ? std::uint32_t(std::max(state_.photons.most, 0)) : 0);
  if (scene_ && camera_.camera() != toldCamera_) renderer_.setCamera(camera_.camera(), sceneVersion_);
  toldCamera_ = camera_.camera();
  Actions const actions = std::exchange(actions_, {});
  perform(actions);
  if (!lockStep_) return;
  renderer_.step(1);
  renderer_.finishSteps();
  for (int k = 0; k < 3; ++k) estimates_[std::size_t(k)] = renderer_.status(k);
}

/// The film takes the size of its place in the window, once that has settled.
void Viewer::matchWindow() {
  Rect const place = picturePlace();
  if (!(place == matchedPlace_)) {
    matchedPlace_ = place;
    matchedSince_ = Clock::now();
  }
  bool const settled = Clock::now() - matchedSince_ > std::chrono::duration<double>(matchPatience);
  if (!state_.matchWindow || place.empty() || !settled) return;
  for (Settings& s : state_.settings) {
    s.width = place.width;
    s.height = place.height;
  }
}

Rect Viewer::picturePlace() const {
  Size const fb = window_.framebufferSize(), size = window_.windowSize();
  float const ratio = size.width > 0 ? float(fb.width) / float(size.width) : 1;
  int const panel = state_.panelShown ? int(panelWidth * gui_.scale() * ratio) : 0;
  bool const covered = panel > fb.width - 16;  // a tiny window: the panel lies over the picture
  return {0, 0, covered ? fb.width : fb.width - panel, fb.height};
}

void Viewer::drawPicture() {
  Size const fb = window_.framebufferSize();
  picture_.update(renderer_, estimates_, renderer_.referenceStatus(), state_);
  overlay_.update(renderer_, picture_, estimates_[estimateA], state_);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  Rect const place = picturePlace();
  glViewport(0, 0, fb.width, fb.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(place.width, 0, std::max(fb.width - place.width, 0), fb.height);  // the picture clears its own place
  glClearColor(0.07f, 0.07f, 0.08f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  picture_.draw(place, fb.height, state_, counts_.seconds);
  const EstimateStatus& a = estimates_[estimateA];
  overlay_.draw(picture_, moved(a.camera, -a.frameOrigin), state_, fb.height, gui_.scale());
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, fb.width, fb.height);
  gui_.end();
}

void Viewer::setTitle() {
  const EstimateStatus& a = estimates_[estimateA];
  std::string const name = std::filesystem::path(scene_ ? scene_->file : comingScene_->file).filename().string();
  std::string const title = fmt::format("{} - {} - {} iterations - ropelight", name,
                                        nameOf(state_.settings[estimateA].mode), a.stats.iterations);
  if (title == title_) return;
  title_ = title;
  window_.setTitle(title);
}

void Viewer::end() {
  if (preferencesFile_.empty()) return;
  Preferences kept{state_, camera_.views, camera_.speed, preferences_.width, preferences_.height};
  if (viewMemory().tone) kept.state.tone = *viewMemory().tone;  // not those that belong to a heat map
  if (viewMemory().brightness) kept.state.imageBrightness = *viewMemory().brightness;
  Size const size = window_.windowSize();
  if (size.width >= 320 && size.height >= 240) {
    kept.width = size.width;
    kept.height = size.height;
  }
  try {
    savePreferences(preferencesFile_, kept);
  } catch (const Error& error) {
    printError("note: {}", error.what());
  }
}

}  // namespace ropelight::view
