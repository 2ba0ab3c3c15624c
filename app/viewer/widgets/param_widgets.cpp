#include "app/viewer/widgets/param_widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "app/viewer/widgets/number_entry.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

constexpr float labelShare = 0.415f;  // of the panel's width
constexpr float tipWidth = 32;        // in font sizes

// One slider is dragged, and one number typed, at a time.
struct {
  ImGuiID id = 0;
  double reference = 0;  // its range must not move under the pointer
} dragged;
struct {
  ImGuiID id = 0;
  std::string text;
} typed;

std::string markOf(const std::string& prefix, const char* name) { return fmt::format("{}/{}", prefix, name); }

bool startsTyping(float width) {
  ImVec2 const low = ImGui::GetCursorScreenPos();
  ImVec2 const high{low.x + width, low.y + ImGui::GetFrameHeight()};
  if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(low, high)) return false;
  return ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0);
}

// The text, in the frame in which it was finished.
std::optional<std::string> typeNumber(float width) {
  ImGui::SetNextItemWidth(width);
  ImGui::InputText("##typed", &typed.text, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CharsScientific);
  std::optional<std::string> finished;
  if (ImGui::IsItemDeactivatedAfterEdit()) finished = typed.text;
  if (!ImGui::IsItemActive()) typed = {};
  return finished;
}

template <class T>
bool dragNumber(ImGuiID id, float width, T& value, const ParamInfo& info) {
  double const reference = dragged.id == id ? dragged.reference : double(value);
  SliderRange const range = sliderRange(info, std::is_integral_v<T>, reference);
  float position = float(sliderPosition(range, double(value)));
  ImGui::SetNextItemWidth(width);
  bool const moved = ImGui::SliderFloat("##slider", &position, 0, 1, shortNumber(value).c_str(),
                                        ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat);
  if (ImGui::IsItemActivated()) dragged = {id, reference};
  if (ImGui::IsItemDeactivated()) dragged = {};
  T const next = limited<T>(sliderValue(range, position), info);
  if (!moved || next == value) return false;
  value = next;
  return true;
}

template <class T>
bool slideOrType(const std::string& mark, T& value, const ParamInfo& info) {
  float const width = ImGui::GetContentRegionAvail().x;
  ImGuiID const id = ImGui::GetID("##slider");
  if (typed.id != id && startsTyping(width)) typed = {id, fmt::format("{}", value)};
  if (typed.id != id) {
    bool const changed = dragNumber(id, width, value, info);
    markWidget(mark);
    paramTip(info);
    return changed;
  }
  std::optional<std::string> const text = typeNumber(width);
  markWidget(mark);
  auto const number = text ? parseNumber<T>(*text, info) : std::nullopt;
  if (!number || *number == value) return false;
  value = *number;
  return true;
}

// What an automatic value came to, in place of the slider.
template <class T>
void showAutomatic(const std::string& mark, T resolved, const ParamInfo& info) {
  float const width = ImGui::GetContentRegionAvail().x;
  std::string const number = resolved != T{} ? shortNumber(resolved) : std::string();
  std::string text = number.empty() ? std::string(info.zero) : fmt::format("{}: {}", info.zero, number);
  if (ImGui::CalcTextSize(text.c_str()).x > width && !number.empty()) text = number;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  ImGui::BeginDisabled();
  ImGui::Button((text + "##automatic").c_str(), {width, 0});
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  markWidget(mark);
  paramTip(info);
}

// Where an automatic value is given up before it is known, the slider's middle is a start.
template <class T>
T firstValue(T resolved, const ParamInfo& info) {
  if (resolved != T{}) return resolved;
  return limited<T>(sliderValue(sliderRange(info, std::is_integral_v<T>, 1), 0.25), info);
}

template <class T>
bool editNumber(const std::string& prefix, const char* name, T& value, const ParamInfo& info, T resolved) {
  std::string const mark = markOf(prefix, name);
  ImGui::PushID(mark.c_str());
  rowLabel(name, info);
  bool changed = false;
  if (*info.zero) {
    bool automatic = value == T{};
    changed = ImGui::Checkbox("auto", &automatic);
    markWidget(mark + "/auto");
    if (changed) value = automatic ? T{} : firstValue(resolved, info);
    ImGui::SameLine();
  }
  if (*info.zero && value == T{})
    showAutomatic(mark, resolved, info);
  else
    changed |= slideOrType(mark, value, info);
  ImGui::PopID();
  return changed;
}

bool comboOf(const std::string& mark, const ParamInfo& info, const std::string& preview, int& index) {
  bool changed = false;
  ImGui::SetNextItemWidth(-1);
  bool const open = ImGui::BeginCombo("##combo", preview.c_str());
  markWidget(mark);
  paramTip(info);
  if (!open) return false;
  for (int i = 0; i < int(info.choices.size()); ++i) {
    const ChoiceInfo& choice = info.choices[std::size_t(i)];
    if (ImGui::Selectable(choice.name, i == index)) {
      changed = i != index;
      index = i;
    }
    if (i == index) ImGui::SetItemDefaultFocus();
    markWidget(fmt::format("{}/{}", mark, choice.name));
    paramTip({.doc = choice.doc});
  }
  ImGui::EndCombo();
  return changed;
}

// What is too long for the column is cut, and whole in the tooltip.
void labelColumn(const char* name, const ParamInfo& info) {
  ImVec2 const start = ImGui::GetCursorPos(), low = ImGui::GetCursorScreenPos();
  float const width = std::floor(ImGui::GetContentRegionAvail().x * labelShare);
  float const gap = ImGui::GetStyle().ItemInnerSpacing.x;
  std::string label(name);
  std::replace(label.begin(), label.end(), '-', ' ');

  ImGui::PushClipRect(low, {low.x + width - gap / 2, low.y + 2 * ImGui::GetFrameHeight()}, true);
  ImGui::BeginGroup();
  ImGui::TextUnformatted(label.c_str());
  if (*info.unit) {
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("%s", info.unit);
  }
  ImGui::EndGroup();
  ImGui::PopClipRect();
  paramTip(info);
  ImGui::SameLine();
  ImGui::SetCursorPosX(start.x + width);
}

}  // namespace

void paramTip(const ParamInfo& info) {
  if (ImGui::IsItemActive() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  std::string const limits = limitsText(info);
  if (!*info.doc && limits.empty()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * tipWidth);
  if (*info.doc) ImGui::TextUnformatted(info.doc);
  if (!limits.empty()) ImGui::TextDisabled("%s", limits.c_str());
  if (!limits.empty() && info.choices.empty()) ImGui::TextDisabled("Ctrl+click to type a number");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void rowLabel(const char* name, const ParamInfo& info) {
  ImGui::AlignTextToFramePadding();
  labelColumn(name, info);
}

void wrappedText(const std::string& text) {
  float const width = ImGui::GetContentRegionAvail().x;
  std::string lines, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::string const longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
      lines += line + "\n";
      line = word;
    } else {
      line = longer;
    }
  }
  ImGui::PushTextWrapPos(0);  // for a word that is longer than a line
  ImGui::TextUnformatted((lines + line).c_str());
  ImGui::PopTextWrapPos();
}

void valueRow(const char* name, const std::string& text, const char* doc) {
  labelColumn(name, ParamInfo{.doc = doc});
  wrappedText(text);
}

bool editParam(const std::string& prefix, const char* name, bool& value, const ParamInfo& info, bool) {
  std::string const mark = markOf(prefix, name);
  ImGui::PushID(mark.c_str());
  rowLabel(name, info);
  bool const changed = ImGui::Checkbox("##on", &value);
  markWidget(mark);
  paramTip(info);
  ImGui::PopID();
  return changed;
}

bool editParam(const std::string& prefix, const char* name, int& value, const ParamInfo& info, int resolved) {
  return editNumber(prefix, name, value, info, resolved);
}
bool editParam(const std::string& prefix, const char* name, std::uint64_t& value, const ParamInfo& info,
               std::uint64_t resolved) {
  return editNumber(prefix, name, value, info, resolved);
}
bool editParam(const std::string& prefix, const char* name, float& value, const ParamInfo& info, float resolved) {
  return editNumber(prefix, name, value, info, resolved);
}
bool editParam(const std::string& prefix, const char* name, double& value, const ParamInfo& info, double resolved) {
  return editNumber(prefix, name, value, info, resolved);
}

bool editChoice(const std::string& prefix, const char* name, int& index, const ParamInfo& info, int resolved) {
  auto const nameAt = [&](int i) {
    return i >= 0 && i < int(info.choices.size()) ? info.choices[std::size_t(i)].name : "";
  };
  std::string const mark = markOf(prefix, name);
  ImGui::PushID(mark.c_str());
  rowLabel(name, info);
  bool const told = *info.zero && index == 0 && resolved != 0;
  bool const changed =
      comboOf(mark, info, told ? fmt::format("{}: {}", info.zero, nameAt(resolved)) : nameAt(index), index);
  ImGui::PopID();
  return changed;
}

}  // namespace ropelight::view
