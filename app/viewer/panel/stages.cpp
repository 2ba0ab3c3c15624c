// Where an iteration's time goes: a table, and stacked bars of the latest batches.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panel/parts.h"
#include "app/viewer/session/stage_history.h"
#include "app/viewer/widgets/param_widgets.h"

namespace ropelight::view {
namespace {

constexpr float plotLines = 5;  // height of the history in lines of text

// Neighbours in a stack must differ: hues a golden ratio apart.
ImU32 stageColour(std::size_t stage) {
  float const hue = std::fmod(0.55f + 0.618034f * float(stage), 1.0f);
  float r = 0, g = 0, b = 0;
  ImGui::ColorConvertHSVtoRGB(hue, 0.55f, 0.85f, r, g, b);
  return ImGui::ColorConvertFloat4ToU32({r, g, b, 1});
}

std::size_t indexOf(const std::vector<StageSummary>& stages, const std::string& name) {
  auto const found = std::find_if(stages.begin(), stages.end(), [&](auto const& s) { return s.name == name; });
  return std::size_t(found - stages.begin());
}

struct Box {
  ImVec2 low, high;
};

void drawBar(const Box& box, float left, float right, const StageSample& sample,
             const std::vector<StageSummary>& stages, double scale) {
  float bottom = box.high.y;
  for (auto const& [name, seconds] : sample) {
    if (!(seconds > 0)) continue;
    float const top = std::max(bottom - float(std::min(seconds * 1e3 * scale, 1e6)), box.low.y);
    ImGui::GetWindowDrawList()->AddRectFilled({left, top}, {right, bottom}, stageColour(indexOf(stages, name)));
    bottom = top;
  }
}

void barTip(const StageSample& sample) {
  ImGui::BeginTooltip();
  for (auto const& [name, seconds] : sample) ImGui::Text("%-16s %8.3f ms", name.c_str(), seconds * 1e3);
  ImGui::EndTooltip();
}

// The latest batch is the right-most bar.
void drawHistory(const std::deque<StageSample>& history, const std::vector<StageSummary>& stages) {
  double const longest = longestSample(history);
  if (!(longest > 0)) return;
  ImVec2 const low = ImGui::GetCursorScreenPos();
  Box const box{low, {low.x + ImGui::GetContentRegionAvail().x, low.y + plotLines * ImGui::GetTextLineHeight()}};
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled(box.low, box.high, ImGui::GetColorU32(ImGuiCol_FrameBg));
  float const step = (box.high.x - box.low.x) / float(stageHistory);
  double const scale = double(box.high.y - box.low.y) / longest;
  float left = box.high.x - step * float(history.size());
  for (const StageSample& sample : history) {
    drawBar(box, left, left + std::max(step, 1.0f), sample, stages, scale);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({left, box.low.y}, {left + step, box.high.y}))
      barTip(sample);
    left += step;
  }
  std::string const top = fmt::format("{:.3g} ms", longest);
  ImVec2 const place{box.low.x + ImGui::GetStyle().FramePadding.x, box.low.y};
  list->AddText(place, ImGui::GetColorU32(ImGuiCol_Text), top.c_str());
  ImGui::Dummy({box.high.x - box.low.x, box.high.y - box.low.y});
}

void numberCell(double value, bool strong) {
  std::string const text = fmt::format("{:.2f}", value);
  ImGui::TableNextColumn();
  float const width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(ImGui::GetContentRegionAvail().x - width, 0.0f));
  if (strong)
    ImGui::TextUnformatted(text.c_str());
  else
    ImGui::TextDisabled("%s", text.c_str());
}

void nameCell(const std::string& name, ImU32 colour) {
  ImGui::TableNextColumn();
  float const edge = ImGui::GetTextLineHeight();
  ImVec2 const low = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + edge * 0.2f}, {low.x + edge * 0.6f, low.y + edge * 0.8f},
                                            colour);
  ImGui::Dummy({edge * 0.6f, edge});
  ImGui::SameLine();
  ImGui::TextUnformatted(name.c_str());
}

void headerRow() {
  ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthStretch, 2.2f);
  for (const char* name : {"min", "mean", "max"}) ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthStretch, 1);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("milliseconds");
  for (const char* name : {"min", "mean", "max"}) {
    ImGui::TableNextColumn();
    float const width = ImGui::CalcTextSize(name).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(ImGui::GetContentRegionAvail().x - width, 0.0f));
    ImGui::TextDisabled("%s", name);
  }
}

void drawTable(const std::vector<StageSummary>& stages) {
  if (!ImGui::BeginTable("##stages", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  headerRow();
  for (std::size_t i = 0; i < stages.size(); ++i) {
    ImGui::TableNextRow();
    nameCell(stages[i].name, stageColour(i));
    numberCell(stages[i].least, false);
    numberCell(stages[i].mean, true);
    numberCell(stages[i].most, false);
  }
  ImGui::EndTable();
}

}  // namespace

void drawStages(PanelContext& context, const EstimateStatus& status) {
  markedCheckbox("measure stages on the GPU", "stages/measure", context.state.stageTimes,
                 "costs a synchronisation a stage; the CPU backend measures always");
  std::vector<StageSummary> const stages = summarizeStages(status.stages);
  if (stages.empty()) return quietText("No stage was measured yet.");
  drawHistory(status.stages, stages);
  drawTable(stages);
}

}  // namespace ropelight::view
