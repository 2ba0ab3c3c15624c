#include "app/view/style.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace ropelight::view {
namespace {

constexpr float fontSize = 13;  // pixels, the default font's own

ImVec4 grey(float value, float alpha = 1) { return {value, value * 1.02f, value * 1.07f, alpha}; }
ImVec4 accent(float strength, float alpha = 1) { return {0.26f * strength, 0.55f * strength, 0.78f * strength, alpha}; }

void setColours(ImVec4* colours) {
  colours[ImGuiCol_Text] = grey(0.90f);
  colours[ImGuiCol_TextDisabled] = grey(0.56f);
  colours[ImGuiCol_WindowBg] = grey(0.115f, 0.97f);
  colours[ImGuiCol_PopupBg] = grey(0.14f, 0.98f);
  colours[ImGuiCol_Border] = grey(0.30f, 0.6f);
  colours[ImGuiCol_FrameBg] = grey(0.19f);
  colours[ImGuiCol_FrameBgHovered] = grey(0.24f);
  colours[ImGuiCol_FrameBgActive] = grey(0.28f);
  colours[ImGuiCol_TitleBg] = grey(0.14f);
  colours[ImGuiCol_TitleBgActive] = grey(0.19f);
  colours[ImGuiCol_Header] = grey(0.21f);
  colours[ImGuiCol_HeaderHovered] = accent(0.7f);
  colours[ImGuiCol_HeaderActive] = accent(0.8f);
  colours[ImGuiCol_Button] = grey(0.25f);
  colours[ImGuiCol_ButtonHovered] = accent(0.7f);
  colours[ImGuiCol_ButtonActive] = accent(0.85f);
  colours[ImGuiCol_SliderGrab] = accent(0.9f);
  colours[ImGuiCol_SliderGrabActive] = accent(1.2f);
  colours[ImGuiCol_CheckMark] = accent(1.25f);
  colours[ImGuiCol_PlotLines] = accent(1.2f);
  colours[ImGuiCol_PlotHistogram] = accent(0.65f);
  colours[ImGuiCol_Separator] = grey(0.26f);
  colours[ImGuiCol_TableRowBgAlt] = {1, 1, 1, 0.025f};
}

}  // namespace

void setStyle(float scale) {
  scale = std::clamp(scale, 0.5f, 8.0f);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  ImGui::StyleColorsDark();
  setColours(style.Colors);
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowRounding = 5;
  style.ScrollbarSize = 11;
  style.ItemSpacing = {6, 4};
  style.ScaleAllSizes(scale);
  ImFontConfig font;
  font.SizePixels = std::floor(fontSize * scale);
  ImFontAtlas* const fonts = ImGui::GetIO().Fonts;
  fonts->Clear();
  fonts->AddFontDefault(&font);
}

}  // namespace ropelight::view
