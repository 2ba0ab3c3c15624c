// What the main loop tells the panel, and writes to files.

#include <imgui.h>

#include <algorithm>

#include "app/run/output.h"
#include "app/viewer/gl/capture.h"
#include "app/viewer/viewer.h"

namespace ropelight::view {

PanelContext Viewer::context() {
  std::vector<double> sorted(frameMs_.begin(), frameMs_.end());
  std::erase(sorted, 0.0);
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2), sorted.end());
  counts_.medianMs = sorted.empty() ? 0 : sorted[sorted.size() / 2];
  PanelContext c{state_,
                 camera_,
                 actions_,
                 estimates_,
                 renderer_.referenceStatus(),
                 renderer_.backendText(),
                 picture_.describePath(),
                 picture_.times(),
                 0,
                 "",
                 {},
                 problem_,
                 notice_,
                 false,
                 0,
                 0,
                 {}};
  c.framesPerSecond = counts_.medianMs > 0 ? 1e3 / counts_.medianMs : 0;
  c.sceneName = scene_ ? scene_->file : comingScene_->file;
  if (scene_) c.sceneNotes = scene_->notes;
  if (problem_.empty()) c.problem = picture_.problem();
  readMagnifier(c);
  return c;
}

void Viewer::readMagnifier(PanelContext& c) {
  Size const fb = window_.framebufferSize(), size = window_.windowSize();
  const ImGuiIO& io = ImGui::GetIO();
  if (size.width == 0 || io.WantCaptureMouse || !ImGui::IsMousePosValid()) return;
  double const ratio = double(fb.width) / size.width;
  c.cursorOnPicture = picture_.pixelAt(io.MousePos.x * ratio, io.MousePos.y * ratio, c.cursorX, c.cursorY);
  if (!c.cursorOnPicture || !state_.inspectorShown) return;
  for (int k = 0; k < 3; ++k) c.magnifier[std::size_t(k)] = picture_.readAround(k, c.cursorX, c.cursorY, magnified);
}

ViewScale Viewer::viewScale() const {
  const CameraDesc& c = camera_.camera();
  const EstimateStatus& a = estimates_[estimateA];
  return {glm::length(c.target - c.position), a.draft ? 0 : a.stats.firstRadius};
}

void Viewer::screenshot(const std::string& file) {
  attempt("saved " + file, [&] {
    requireNoInput(file, inputs());
    Size const fb = window_.framebufferSize();
    saveScreenshot(file, captureScreen(fb.width, fb.height));
  });
}

void Viewer::writeState(const std::string& file) {
  attempt("", [&] {
    requireNoInput(file, inputs());
    writeJson(file, stateReport(context(), picture_, window_, counts_, controls_.selection()));
    counts_.slowestMs = 0;
  });
}

}  // namespace ropelight::view
