// Opening and saving.

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/widgets/param_widgets.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

// Typed but not yet used: not part of the view's state.
std::string path, name;
bool focusWanted = false;

void open(PanelContext& context, const std::string& file) {
  if (!file.empty()) context.actions.open.push_back(file);
}

void drawPathBox(PanelContext& context) {
  float const button = ImGui::CalcTextSize("open").x + 4 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  if (focusWanted) ImGui::SetKeyboardFocusHere();
  bool const entered = ImGui::InputTextWithHint("##path", "scene, or .exr or .png as reference", &path,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemActive()) focusWanted = false;
  markWidget("files/path");
  ImGui::SameLine();
  bool const pressed = markedButton("open", "files/open", "files can also be dropped on the window", -1);
  if (entered || pressed) open(context, path);
}

void drawRecent(PanelContext& context) {
  int index = 0;
  for (const std::string& file : context.state.recent) {
    std::string const shown = std::filesystem::path(file).filename().string();
    ImGui::PushID(index);
    if (ImGui::Selectable(shown.empty() ? file.c_str() : shown.c_str())) open(context, file);
    ImGui::PopID();
    markWidget(fmt::format("files/recent/{}", index++));
    paramTip({.doc = file.c_str()});
  }
}

void saveButton(PanelContext& context, const char* label, const char* mark, const char* ending, std::string& action,
                float width) {
  std::string const file = savedFile(context, ending);
  ImGui::PushID(mark);
  if (ImGui::Button(label, {width, 0})) action = file;
  ImGui::PopID();
  markWidget(mark);
  if (!ImGui::IsItemHovered()) return;
  std::error_code ignored;
  bool const there = std::filesystem::exists(file, ignored);
  ImGui::SetTooltip("writes %s%s", file.c_str(), there ? ", replacing what is there" : "");
}

void drawSave(PanelContext& context) {
  rowLabel("save as", {.doc = "path and name without an ending; each button adds its own"});
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##name", savedFile(context, "").c_str(), &name);
  markWidget("files/name");
  Actions& actions = context.actions;
  float const three = buttonWidth(3);
  saveButton(context, "PNG", "files/save-png", ".png", actions.savePng, three);
  ImGui::SameLine();
  saveButton(context, "EXR", "files/save-exr", ".exr", actions.saveExr, three);
  ImGui::SameLine();
  saveButton(context, "window", "files/screenshot", "-window.png", actions.screenshot, three);
  float const two = buttonWidth(2);
  saveButton(context, "camera", "files/save-camera", "-camera.json", actions.saveCamera, two);
  ImGui::SameLine();
  saveButton(context, "settings", "files/save-settings", "-settings.json", actions.saveSettings, two);
}

}  // namespace

std::string savedFile(const PanelContext& context, const char* ending) {
  if (!name.empty()) return name + ending;
  std::string base = context.sceneName.empty() ? "ropelight" : context.sceneName;
  std::replace(base.begin(), base.end(), '/', '-');
  return base + ending;
}

void focusPathBox() { focusWanted = true; }
bool pathBoxWanted() { return focusWanted; }

void drawFiles(PanelContext& context) {
  drawPathBox(context);
  drawRecent(context);
  ImGui::Separator();
  drawSave(context);
}

}  // namespace ropelight::view
