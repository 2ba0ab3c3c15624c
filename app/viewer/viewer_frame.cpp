// When a frame is due, its input, and its end.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/viewer/viewer.h"

namespace ropelight::view {
namespace {

constexpr double shortestFrame = 1.0 / 60;
constexpr double longestFrame = 1.0 / 30;                   ///< where drawing leaves that much
constexpr auto attention = std::chrono::milliseconds(700);  ///< after the latest input

}  // namespace

/// A window in which nothing would change is not drawn again: on a machine without a GPU the time is better spent on
/// accumulation.
bool Viewer::frameWanted() {
  if (window_.takeActivity()) lastInput_ = Clock::now();
  std::array<std::uint64_t, 6> shown{};
  for (std::size_t k = 0; k < 3; ++k) {
    shown[2 * k] = estimates_[k].pixelVersion;
    shown[2 * k + 1] = std::uint64_t(estimates_[k].building) + 2 * std::hash<std::string>()(estimates_[k].problem);
  }
  bool const changed = shown != shown_ || problem_ != shownProblem_;
  bool const attended = Clock::now() - lastInput_ < attention || (script_ && script_->running());
  bool const flickers = compares(state_) && state_.compare.layout == Layout::flicker;
  if (!changed && !attended && !flickers && !lockStep_ && counts_.frames > 3) return false;
  shown_ = shown;
  shownProblem_ = problem_;
  return true;
}

void Viewer::takeInput() {
  gui_.setScale(window_.contentScale() * float(options_.uiScale));
  gui_.beginBackends();
  catchTaps();
  for (const std::string& file : window_.takeDroppedFiles()) actions_.open.push_back(file);
  if (!script_) return;
  const EstimateStatus& a = estimates_[estimateA];
  bool const busy = loader_.busy() || renderer_.busy() || !a.ready || a.draft;
  ScriptRequests const asked = script_->apply(ImGui::GetIO(), counts_.seconds, double(a.pixelIterations), busy);
  for (const std::string& file : asked.drop) actions_.open.push_back(file);
  for (const std::string& file : asked.screenshots) screenshots_.push_back(file);
  for (const std::string& file : asked.stateFiles) stateFiles_.push_back(file);
  if (asked.resizeWidth > 0) window_.resize(asked.resizeWidth, asked.resizeHeight);
  if (asked.quit || !script_->problem().empty()) done_ = true;
}

/// A key that is up again before the frame began counts as down for this frame; the next one sees it released.
void Viewer::catchTaps() {
  ImGuiIO& io = ImGui::GetIO();
  if (!taps_.empty()) {
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
  }
  for (int key : std::exchange(taps_, {})) io.KeysDown[key] = false;
  for (const Window::KeyTap& tap : window_.takeKeyTaps()) {
    if (tap.key < 0 || tap.key >= IM_ARRAYSIZE(io.KeysDown) || io.KeysDown[tap.key]) continue;
    io.KeysDown[tap.key] = true;
    io.KeyCtrl = io.KeyCtrl || (tap.modifiers & GLFW_MOD_CONTROL) != 0;
    io.KeyShift = io.KeyShift || (tap.modifiers & GLFW_MOD_SHIFT) != 0;
    taps_.push_back(tap.key);
  }
}

void Viewer::finishFrame() {
  ++counts_.frames;
  bool const last = options_.frames > 0 && counts_.frames >= options_.frames;
  if (last && !options_.screenshot.empty()) screenshots_.push_back(options_.screenshot);
  if (last && !options_.state.empty()) stateFiles_.push_back(options_.state);
  for (const std::string& file : std::exchange(screenshots_, {})) screenshot(file);
  window_.swap();
  for (const std::string& file : std::exchange(stateFiles_, {})) writeState(file);
  setTitle();
  if (last) done_ = true;
}

/// Waits for events for what is left of the frame: the time is left to accumulation, at least half of it where the same
/// cores draw.
void Viewer::pace() {
  auto const elapsed = [this] { return std::chrono::duration<double>(Clock::now() - frameStart_).count(); };
  double const frame = std::clamp(2 * elapsed(), shortestFrame, longestFrame);
  if (!lockStep_)
    while (elapsed() < frame) window_.poll(frame - elapsed());  // events come in between
  window_.poll();
  bool const drawn = counts_.frames != framesBefore_, inARow = drawn && drewBefore_;
  framesBefore_ = counts_.frames;
  drewBefore_ = drawn;
  frameSeconds_ = elapsed();
  frameStart_ = Clock::now();
  counts_.seconds = std::chrono::duration<double>(Clock::now() - started_).count();
  if (!inARow) return;
  frameMs_[counts_.frames % frameMs_.size()] = frameSeconds_ * 1e3;
  counts_.slowestMs = std::max(counts_.slowestMs, frameSeconds_ * 1e3);
}

}  // namespace ropelight::view
