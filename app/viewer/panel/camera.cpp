// The camera by numbers, and saved views.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/widgets/number_entry.h"
#include "app/viewer/widgets/param_widgets.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

bool isUsable(const CameraDesc& camera) {
  for (int i = 0; i < 3; ++i)
    for (double v : {camera.position[i], camera.target[i]})
      if (!(std::abs(v) <= maxCoordinate)) return false;
  return glm::length(camera.target - camera.position) > 0;
}

// Three numbers that are dragged by a share of the viewing distance.
bool editPoint(const char* name, const char* mark, Vec3d& point, double distance, const char* doc) {
  rowLabel(name, {.doc = doc});
  ImGui::PushID(mark);
  ImGui::SetNextItemWidth(-1);
  bool const changed = ImGui::DragScalarN("##point", ImGuiDataType_Double, &point.x, 3, float(distance) * 0.004f,
                                          nullptr, nullptr, coordinateFormat(distance).c_str());
  ImGui::PopID();
  markWidget(mark);
  return changed;
}

void drawPlace(CameraControl& control) {
  CameraDesc camera = control.camera();
  double const distance = glm::length(camera.target - camera.position);
  bool changed =
      editPoint("position", "camera/position", camera.position, distance, "in scene units; drag, or Ctrl+click");
  changed |= editPoint("target", "camera/target", camera.target, distance, "what orbit turns around");
  if (changed && isUsable(camera)) control.setCamera(camera);
}

void drawLens(CameraControl& control) {
  const CameraDesc camera = control.camera();
  double const distance = glm::length(camera.target - camera.position);
  double fov = camera.verticalFov, aperture = camera.apertureRadius, focus = camera.focusDistance;
  if (editParam("camera", "fov", fov,
                {.doc = "full vertical angle", .min = minFov, .max = maxFov, .unit = "degrees", .low = 5, .high = 120}))
    control.setFov(fov);
  if (editParam("camera", "aperture", aperture,
                {.doc = "radius of the lens; 0: a pinhole, all in focus",
                 .min = 0,
                 .max = maxCoordinate,
                 .unit = "scene units",
                 .high = distance / 10}))
    control.setAperture(aperture);
  if (editParam("camera", "focus", focus,
                {.doc = "distance of the plane in focus; Ctrl+left click in the picture sets it",
                 .min = 0,
                 .max = maxCoordinate,
                 .unit = "scene units",
                 .logarithmic = true,
                 .zero = "at the target"},
                distance))
    control.setFocusDistance(focus);
  editParam("camera", "speed", control.speed,
            {.doc = "of flying, in diagonals of the scene's bounds per 5 seconds",
             .min = 1e-6,
             .max = 1e6,
             .low = 0.01,
             .high = 100,
             .logarithmic = true});
}

void drawViews(PanelContext& context) {
  float const width = buttonWidth(3);
  if (markedButton("save view", "camera/save-view", "keep this camera in the list below", width))
    context.actions.saveView = true;
  ImGui::SameLine();
  if (markedButton("copy JSON", "camera/copy", "the camera as scene JSON to the clipboard", width))
    context.actions.copyCamera = true;
  ImGui::SameLine();
  if (markedButton("save JSON", "camera/save", "the camera as a file, named as in Files", width))
    context.actions.saveCamera = savedFile(context, "-camera.json");

  int index = 0;
  for (const SavedView& view : context.camera.views) {
    ImGui::PushID(index);
    if (ImGui::Selectable(view.name.empty() ? "(no name)" : view.name.c_str())) context.actions.restoreView = index;
    ImGui::PopID();
    markWidget(fmt::format("views/{}", index));
    paramTip({.doc = "click to look from there"});
    ++index;
  }
}

}  // namespace

void drawCamera(PanelContext& context) {
  drawPlace(context.camera);
  drawLens(context.camera);
  float const width = buttonWidth(3);
  if (markedButton("reset##camera", "camera/reset", "the scene's own camera (R)", width))
    context.actions.resetCamera = true;
  ImGui::SameLine();
  if (markedButton("frame all", "camera/frame-all", "see the whole scene (Shift+F)", width))
    context.actions.frameAll = true;
  ImGui::SameLine();
  if (markedButton("selection", "camera/frame-selection", "see the selected shape (F)", width))
    context.actions.frameSelection = true;
  drawViews(context);
}

}  // namespace ropelight::view
