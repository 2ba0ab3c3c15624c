#include "app/viewer/widgets/gui.h"

#include "app/viewer/gl/gl.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/gl/window.h"
#include "render/core/error.h"

namespace ropelight::view {
namespace {

ImVec4 grey(float value, float alpha = 1) { return {value, value, value * 1.03f, alpha}; }
ImVec4 accent(float value, float alpha = 1) { return {0.36f * value, 0.60f * value, 0.95f * value, alpha}; }

void setColours(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  ImVec4* const c = style.Colors;
  c[ImGuiCol_Text] = grey(0.88f);
  c[ImGuiCol_TextDisabled] = grey(0.52f);
  c[ImGuiCol_WindowBg] = grey(0.13f, 0.97f);
  c[ImGuiCol_PopupBg] = grey(0.11f, 0.98f);
  c[ImGuiCol_Border] = grey(0.26f);
  c[ImGuiCol_FrameBg] = grey(0.20f);
  c[ImGuiCol_FrameBgHovered] = grey(0.26f);
  c[ImGuiCol_FrameBgActive] = grey(0.30f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgCollapsed] = grey(0.10f);
  c[ImGuiCol_TitleBgActive] = grey(0.16f);
  c[ImGuiCol_Header] = c[ImGuiCol_Button] = grey(0.24f);
  c[ImGuiCol_HeaderHovered] = c[ImGuiCol_ButtonHovered] = accent(0.55f);
  c[ImGuiCol_HeaderActive] = c[ImGuiCol_ButtonActive] = accent(0.75f);
  c[ImGuiCol_Tab] = grey(0.18f);
  c[ImGuiCol_TabHovered] = accent(0.65f);
  c[ImGuiCol_TabActive] = accent(0.50f);
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_CheckMark] = c[ImGuiCol_PlotHistogram] = accent(0.9f);
  c[ImGuiCol_SliderGrabActive] = accent(1.0f);
  c[ImGuiCol_ScrollbarBg] = grey(0.11f, 0.6f);
  c[ImGuiCol_Separator] = grey(0.26f);
}

void setSizes(ImGuiStyle& style, float scale) {
  style.WindowPadding = {8, 8};
  style.FramePadding = {5, 3};
  style.ItemSpacing = {7, 4};
  style.ScrollbarSize = 12;
  style.GrabMinSize = 10;
  style.WindowRounding = style.PopupRounding = 3;
  style.FrameRounding = style.GrabRounding = style.TabRounding = style.ScrollbarRounding = 2;
  style.ScaleAllSizes(scale);
}

void setFont(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);
  fonts.AddFontDefault(&config);
}

}  // namespace

Gui::Gui(const Window& window, float scale) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // what is kept between runs, preferences.cpp keeps
  ImGui::GetIO().LogFilename = nullptr;
  bool const platform = ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
  if (!platform || !ImGui_ImplOpenGL3_Init("#version 330 core"))
    throw Error("Dear ImGui's backends do not start on this window", ExitCode::internal);
  setScale(scale);
  ImGui_ImplOpenGL3_CreateDeviceObjects();
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Gui::setScale(float scale) {
  scale = std::clamp(scale, 0.5f, 8.0f);
  if (scale == scale_) return;
  bool const first = scale_ == 0;
  scale_ = scale;
  ImGuiStyle style;
  setColours(style);
  setSizes(style, scale);
  ImGui::GetStyle() = style;
  setFont(scale);
  if (first) return;
  // The texture alone: the backend of 1.86 does not notice that buffers which it makes again are empty.
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Gui::beginBackends() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
}

void Gui::begin() { ImGui::NewFrame(); }

void Gui::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace ropelight::view
