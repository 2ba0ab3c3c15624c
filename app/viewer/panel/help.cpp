// The keys and what the mouse does.

#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "app/viewer/state/key_table.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

void drawRow(const KeyHelp& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (!*row.what) {
    ImGui::TextDisabled("%s", row.keys);
    return;
  }
  ImGui::TextUnformatted(row.keys);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.what);
}

}  // namespace

void drawHelp(PanelContext& context) {
  ImVec2 const display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x, display.y});
  constexpr auto flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::Begin("Keys and mouse", &context.state.helpShown, flags)) {
    if (ImGui::BeginTable("##keys", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_PadOuterX)) {
      for (const KeyHelp& row : keyTable) drawRow(row);
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace ropelight::view
