#include "app/viewer/panel/parts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/widgets/param_widgets.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {

bool partHeader(const char* name, bool open) {
  ImGui::SetNextItemOpen(open, ImGuiCond_Once);
  bool const shown = ImGui::CollapsingHeader(name);
  markWidget(fmt::format("header/{}", name));
  return shown;
}

bool subHeader(const std::string& name, bool open) {
  ImGui::SetNextItemOpen(open, ImGuiCond_Once);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
  bool const shown =
      ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
  ImGui::PopStyleColor();
  markWidget(fmt::format("group/{}", name));
  return shown;
}

bool markedButton(const char* label, const char* mark, const char* tip, float width) {
  ImGui::PushID(mark);
  bool const pressed = ImGui::Button(label, {width, 0});
  ImGui::PopID();
  markWidget(mark);
  paramTip({.doc = tip});
  return pressed;
}

bool markedCheckbox(const char* label, const char* mark, bool& value, const char* tip) {
  ImGui::PushID(mark);
  bool const changed = ImGui::Checkbox(label, &value);
  ImGui::PopID();
  markWidget(mark);
  paramTip({.doc = tip});
  return changed;
}

float buttonWidth(int count) {
  float const gaps = float(count - 1) * ImGui::GetStyle().ItemSpacing.x;
  return std::max((ImGui::GetContentRegionAvail().x - gaps) / float(count), 1.0f);
}

void problemText(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.42f, 0.38f, 1.0f));
  wrappedText(text);
  ImGui::PopStyleColor();
}

void quietText(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  wrappedText(text);
  ImGui::PopStyleColor();
}

ViewScale viewScale(const PanelContext& context) {
  const CameraDesc& camera = context.camera.camera();
  const Stats& stats = context.estimates[std::size_t(context.state.edited)].stats;
  return {glm::length(camera.target - camera.position), stats.firstRadius};
}

}  // namespace ropelight::view
