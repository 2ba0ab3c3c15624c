#include "app/viewer/input/controls.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/camera/pick.h"
#include "app/viewer/panel/panel.h"

namespace ropelight::view {
namespace {

bool pressed(int key) { return ImGui::IsKeyPressed(key, false); }
bool repeated(int key) { return ImGui::IsKeyPressed(key, true); }

double aspectOf(const Picture& picture) {
  Rect const r = picture.pictureRect(0);
  return r.empty() ? 1 : double(r.width) / r.height;
}

void choose(const ControlTargets& t, const char* name) {
  for (const Preset& preset : presets)
    if (std::string(name) == preset.name) applyPreset(t.state, viewMemory(), preset, t.scale);
}

}  // namespace

Layout nextLayout(Layout layout) { return Layout((int(layout) + 1) % (int(Layout::difference) + 1)); }
Curve nextCurve(Curve curve) { return Curve((int(curve) + 1) % (int(Curve::falseColour) + 1)); }

void Controls::apply(const ControlTargets& targets) {
  notice_.clear();
  const ImGuiIO& io = ImGui::GetIO();
  mouse(targets);
  if (io.WantCaptureKeyboard || io.WantTextInput) return;
  if (io.KeyCtrl) return shortcuts(targets);
  fly(targets);
  keys(targets);
  displayKeys(targets);
}

void Controls::mouse(const ControlTargets& t) {
  const ImGuiIO& io = ImGui::GetIO();
  double const x = io.MousePos.x * t.pixelRatio, y = io.MousePos.y * t.pixelRatio;
  bool const over = !io.WantCaptureMouse && t.picture.pictureRect(0).width > 0;
  for (int button = 0; button < 3 && over; ++button)
    if (ImGui::IsMouseClicked(button)) {
      dragged_ = button;
      Rect const left = t.picture.visibleRect(0);
      bool const nearSplit = std::abs(x - (left.x + left.width)) < 6 * t.pixelRatio;
      splitDragged_ = button == 0 && t.state.compare.layout == Layout::split && compares(t.state) && nearSplit;
    }
  if (dragged_ >= 0 && !ImGui::IsMouseDown(dragged_)) dragged_ = -1;
  drag(t);
  if (!over) return;
  if (io.MouseWheel != 0) t.camera.dolly(0.12 * double(io.MouseWheel));
  double px, py;
  if (!t.picture.placeAt(x, y, px, py)) return;
  if (io.KeyCtrl && ImGui::IsMouseClicked(0)) point(t, true);
  if (!io.KeyCtrl && ImGui::IsMouseDoubleClicked(0)) point(t, false);
}

void Controls::drag(const ControlTargets& t) {
  const ImGuiIO& io = ImGui::GetIO();
  if (dragged_ < 0 || io.KeyCtrl || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
  Rect const whole = t.picture.pictureRect(0);
  double const height = std::max(whole.height, 1) / t.pixelRatio;
  double const right = double(io.MouseDelta.x) / height, up = -double(io.MouseDelta.y) / height;
  double const field = t.camera.camera().verticalFov * M_PI / 180;
  if (splitDragged_)
    t.state.compare.split =
        float(std::clamp((io.MousePos.x * t.pixelRatio - whole.x) / std::max(whole.width, 1), 0.0, 1.0));
  else if (dragged_ == 2 || (dragged_ == 0 && io.KeyAlt))
    t.camera.look(right * field, up * field);
  else if (dragged_ == 1 || io.KeyShift)
    t.camera.pan(-right, -up);
  else
    t.camera.orbit(-right * M_PI, -up * M_PI);
}

/// Focus on, or selection of, what is under the cursor.
void Controls::point(const ControlTargets& t, bool focus) {
  const ImGuiIO& io = ImGui::GetIO();
  double px, py;
  if (!t.scene || !t.picture.placeAt(io.MousePos.x * t.pixelRatio, io.MousePos.y * t.pixelRatio, px, py)) return;
  const CameraDesc& camera = t.camera.camera();
  auto const hit = pick(*t.scene, camera.position, t.camera.directionThrough(px, py, aspectOf(t.picture)));
  if (!hit) {
    if (!focus) selection_ = -1;
    notice_ = focus ? "nothing to focus on there" : "nothing is selected";
    return;
  }
  const std::string& name = t.scene->shapes[std::size_t(hit->shape)].name;
  std::string const shape = name.empty() ? fmt::format("shape {}", hit->shape) : name;
  if (focus) {
    double const distance = glm::dot(hit->point - camera.position, glm::normalize(camera.target - camera.position));
    t.camera.setFocusDistance(distance);
    notice_ = fmt::format("focus at {:.4g} on {}", distance, shape);
  } else {
    selection_ = hit->shape;
    notice_ = fmt::format("selected: {}", shape);
  }
}

void Controls::fly(const ControlTargets& t) {
  auto const axis = [](int plus, int minus) {
    return double(ImGui::IsKeyDown(plus)) - double(ImGui::IsKeyDown(minus));
  };
  Vec3d const direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S));
  if (direction == Vec3d(0)) return;
  double const seconds = std::min(t.seconds, 0.1);  // a long frame is no leap
  t.camera.fly(direction, ImGui::GetIO().KeyShift ? 4 * seconds : seconds);
}

void Controls::keys(const ControlTargets& t) {
  bool const shift = ImGui::GetIO().KeyShift;
  if (pressed(GLFW_KEY_F)) (shift ? t.actions.frameAll : t.actions.frameSelection) = true;
  if (pressed(GLFW_KEY_R) || pressed(GLFW_KEY_HOME)) t.actions.resetCamera = true;
  if (pressed(GLFW_KEY_SPACE)) t.state.paused = !t.state.paused;
  if (repeated(GLFW_KEY_PERIOD)) {
    t.state.paused = true;
    ++t.actions.steps;
  }
  if (pressed(GLFW_KEY_BACKSPACE)) t.actions.reset = true;
  if (pressed(GLFW_KEY_1)) choose(t, "ray");
  if (pressed(GLFW_KEY_2)) choose(t, "path");
  if (pressed(GLFW_KEY_3)) choose(t, "sppm");
  if (pressed(GLFW_KEY_C)) {
    CompareSettings& compare = t.state.compare;
    compare.enabled = !compare.enabled;
    if (compare.enabled && compare.layout == Layout::single) compare.layout = Layout::split;
  }
  if (pressed(GLFW_KEY_F2)) t.actions.screenshot = "*";
}

void Controls::displayKeys(const ControlTargets& t) {
  const ImGuiIO& io = ImGui::GetIO();
  ViewState& s = t.state;
  if (pressed(GLFW_KEY_V)) s.compare.layout = nextLayout(s.compare.layout);
  if (repeated(GLFW_KEY_LEFT_BRACKET)) s.compare.split = std::max(s.compare.split - 0.02f, 0.0f);
  if (repeated(GLFW_KEY_RIGHT_BRACKET)) s.compare.split = std::min(s.compare.split + 0.02f, 1.0f);
  if (repeated(GLFW_KEY_EQUAL) || repeated(GLFW_KEY_KP_ADD)) s.tone.exposure = std::min(s.tone.exposure + 0.25f, 30.0f);
  if (repeated(GLFW_KEY_MINUS) || repeated(GLFW_KEY_KP_SUBTRACT))
    s.tone.exposure = std::max(s.tone.exposure - 0.25f, -30.0f);
  if (pressed(GLFW_KEY_T)) s.tone.curve = nextCurve(s.tone.curve);
  if (pressed(GLFW_KEY_P)) s.photons.shown = !s.photons.shown;
  if (pressed(GLFW_KEY_K)) s.tree.shown = !s.tree.shown;
  if (pressed(GLFW_KEY_I)) s.inspectorShown = !s.inspectorShown;
  if (pressed(GLFW_KEY_L)) s.plotShown = !s.plotShown;
  if (pressed(GLFW_KEY_TAB)) s.panelShown = !s.panelShown;
  bool const question = pressed(GLFW_KEY_SLASH) && io.KeyShift;
  if (pressed(GLFW_KEY_F1) || question) s.helpShown = !s.helpShown;
  if (pressed(GLFW_KEY_ESCAPE)) s.helpShown = false;
}

void Controls::shortcuts(const ControlTargets& t) {
  if (pressed(GLFW_KEY_S)) t.actions.savePng = t.actions.saveExr = "*";
  if (pressed(GLFW_KEY_O)) {
    t.state.panelShown = true;
    focusPathBox();
  }
  if (pressed(GLFW_KEY_Q)) t.actions.quit = true;
}

}  // namespace ropelight::view
