#include "app/viewer/panel/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/run/report.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/preferences/presets.h"
#include "app/viewer/widgets/param_widgets.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

void drawViewCombo(PanelContext& context) {
  const Preset* const shown = currentPreset(context.state);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("view");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  bool const open = ImGui::BeginCombo("##view", shown ? shown->name : "custom", ImGuiComboFlags_HeightLargest);
  markWidget("view");
  if (!open) return;
  for (const Preset& preset : presets) {
    if (ImGui::Selectable(preset.name, &preset == shown))
      applyPreset(context.state, viewMemory(), preset, viewScale(context));
    std::string mark = fmt::format("view/{}", preset.name);
    std::replace(mark.begin(), mark.end(), ' ', '-');
    markWidget(mark);
    paramTip({.doc = preset.doc});
  }
  ImGui::EndCombo();
}

void drawRunButtons(PanelContext& context) {
  float const width = buttonWidth(3);
  if (markedButton(context.state.paused ? "run" : "pause", "pause", "Space", width))
    context.state.paused = !context.state.paused;
  ImGui::SameLine();
  if (markedButton("step", "step", "pause and add one iteration (.)", width)) {
    context.state.paused = true;
    ++context.actions.steps;
  }
  ImGui::SameLine();
  if (markedButton("reset", "reset", "accumulation starts again (Backspace)", width)) context.actions.reset = true;
}

std::string progress(const EstimateStatus& status, const Settings& settings) {
  if (!status.ready) return status.building ? "building..." : "not ready";
  return fmt::format("{}: {} iterations, {:.1f} s, {:.3g} it/s", nameOf(settings.mode), status.stats.iterations,
                     status.stats.seconds, iterationRate(status.stats));
}

// One line per estimate; with two of them also the choice of which one the panel edits.
void drawEstimates(PanelContext& context) {
  ViewState& state = context.state;
  if (!state.compare.enabled) {
    state.edited = estimateA;
    ImGui::TextUnformatted(progress(context.estimates[0], state.settings[0]).c_str());
    return;
  }
  for (int which : {estimateA, estimateB}) {
    bool const chosen = state.edited == which;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ButtonActive : ImGuiCol_FrameBg));
    if (markedButton(which == estimateA ? " A " : " B ", which == estimateA ? "edit/A" : "edit/B",
                     "the settings below are of this estimate"))
      state.edited = which;
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(progress(context.estimates[std::size_t(which)], state.settings[std::size_t(which)]).c_str());
  }
}

void drawMessages(const PanelContext& context) {
  if (!context.problem.empty()) problemText(context.problem);
  if (!context.notice.empty()) quietText(context.notice);
}

void drawTop(PanelContext& context) {
  drawViewCombo(context);
  drawRunButtons(context);
  drawEstimates(context);
  drawMessages(context);
  ImGui::Separator();
}

struct Part {
  const char* name;
  bool open;
  void (*draw)(PanelContext&);
};

constexpr Part parts[] = {
    {"Settings", true, drawSettings},  {"Compare", false, drawCompare}, {"Display", true, drawTone},
    {"Overlays", false, drawOverlays}, {"Camera", false, drawCamera},   {"Statistics", true, drawStatistics},
    {"Files", false, drawFiles},
};

void drawParts(PanelContext& context) {
  ImGui::BeginChild("##parts", {0, 0}, false);
  for (const Part& part : parts) {
    if (part.draw == drawFiles && pathBoxWanted()) ImGui::SetNextItemOpen(true);
    if (!partHeader(part.name, part.open)) continue;
    ImGui::PushID(part.name);
    part.draw(context);
    ImGui::PopID();
    ImGui::Spacing();
  }
  ImGui::EndChild();
}

}  // namespace

void drawPanel(PanelContext& context, float width) {
  if (context.state.panelShown) {
    ImVec2 const display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x - width, 0});
    ImGui::SetNextWindowSize({width, display.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    constexpr auto docked = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
    if (ImGui::Begin("ropelight", nullptr, docked)) {
      drawTop(context);
      drawParts(context);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
  }
  if (context.state.plotShown) drawErrorPlot(context);
  if (context.state.inspectorShown) drawInspector(context);
  if (context.state.helpShown) drawHelp(context);
}

}  // namespace ropelight::view
