// The pixel under the cursor: its values in every image, and its neighbours enlarged.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/viewer/draw/false_colour.h"
#include "app/viewer/panel/panel.h"
#include "render/film/tonemap.h"

namespace ropelight::view {
namespace {

constexpr const char* imageNames[] = {"A", "B", "reference"};
constexpr ImU32 magenta = IM_COL32(255, 60, 255, 255);
constexpr std::size_t gridPixels = std::size_t(magnified) * std::size_t(magnified);

struct Pixel {
  float value[3] = {};
  float alpha = std::numeric_limits<float>::quiet_NaN();  // NaN: not on the film

  bool onFilm() const { return !std::isnan(alpha); }
  bool finite() const { return std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]); }
  float mean() const { return (value[0] + value[1] + value[2]) / 3; }
};

Pixel pixelAt(const std::vector<float>& image, std::size_t index) {
  if (image.size() < 4 * gridPixels) return {};
  const float* const p = image.data() + 4 * index;
  return {{p[0], p[1], p[2]}, p[3]};
}

float falsePosition(float value, const ToneSettings& tone) {
  float const low = tone.falseLow, high = tone.falseHigh;
  if (!(high > low)) return 0;
  if (!tone.falseLogarithmic || !(low > 0)) return (value - low) / (high - low);
  return value > 0 ? std::log(value / low) / std::log(high / low) : 0;
}

ImU32 screenColour(const Pixel& pixel, const ToneSettings& tone) {
  if (!pixel.finite()) return magenta;
  if (tone.curve == Curve::falseColour) {
    auto const colour = falseColour(falsePosition(pixel.mean(), tone));
    return ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1});
  }
  float encoded[3];
  for (int i = 0; i < 3; ++i) {
    double const exposed = double(pixel.value[i]) * std::exp2(double(tone.exposure));
    encoded[i] = float(encodeSrgb(std::clamp(exposed, 0.0, 1.0)));
  }
  return ImGui::ColorConvertFloat4ToU32({encoded[0], encoded[1], encoded[2], 1});
}

void drawMagnifier(const std::vector<float>& image, const ToneSettings& tone, float edge) {
  ImVec2 const low = ImGui::GetCursorScreenPos();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  float const cell = edge / float(magnified);
  for (int y = 0; y < magnified; ++y)
    for (int x = 0; x < magnified; ++x) {
      Pixel const pixel = pixelAt(image, std::size_t(y * magnified + x));
      if (!pixel.onFilm()) continue;
      ImVec2 const corner{low.x + float(x) * cell, low.y + float(y) * cell};
      list->AddRectFilled(corner, {corner.x + cell, corner.y + cell}, screenColour(pixel, tone));
    }
  float const middle = float(magnified / 2) * cell;
  ImVec2 const a{low.x + middle, low.y + middle}, b{a.x + cell, a.y + cell};
  list->AddRect({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, IM_COL32_BLACK, 0, 0, 3);
  list->AddRect({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, IM_COL32_WHITE);
  list->AddRect(low, {low.x + edge, low.y + edge}, ImGui::GetColorU32(ImGuiCol_Border));
  ImGui::Dummy({edge, edge});
}

void valueCell(float value) {
  ImGui::TableNextColumn();
  if (std::isfinite(value))
    ImGui::Text("%11.5g", double(value));
  else
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(magenta), "%11s", std::isnan(value) ? "NaN" : "Inf");
}

void channelRow(const char* name, const std::array<Pixel, 3>& pixels, int channel) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  for (const Pixel& pixel : pixels) {
    if (pixel.onFilm())
      valueCell(channel < 3 ? pixel.value[channel] : pixel.mean());
    else
      ImGui::TableNextColumn();
  }
}

// Of the means, against the reference where there is one, else of A against B.
void differenceRow(const std::array<Pixel, 3>& pixels) {
  std::size_t const base = pixels[2].onFilm() ? 2 : 1;
  if (!pixels[base].onFilm()) return;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled(base == 2 ? "to ref." : "to B");
  for (std::size_t i = 0; i < base; ++i) {
    ImGui::TableNextColumn();
    float const difference = pixels[i].mean() - pixels[base].mean();
    if (!pixels[i].onFilm() || !std::isfinite(difference)) continue;
    if (pixels[base].mean() != 0)
      ImGui::Text("%+10.2f%%", 100 * double(difference / pixels[base].mean()));
    else
      ImGui::Text("%+11.4g", double(difference));
  }
}

void drawTable(const PanelContext& context, float edge) {
  std::array<Pixel, 3> pixels;
  for (std::size_t i = 0; i < 3; ++i) pixels[i] = pixelAt(context.magnifier[i], gridPixels / 2);
  if (!ImGui::BeginTable("##values", 4, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  for (std::size_t i = 0; i < 3; ++i) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", imageNames[i]);
    if (context.magnifier[i].empty())
      ImGui::Dummy({edge, edge});
    else
      drawMagnifier(context.magnifier[i], context.state.tone, edge);
  }
  constexpr const char* rows[] = {"red", "green", "blue", "mean"};
  for (int channel = 0; channel < 4; ++channel) channelRow(rows[channel], pixels, channel);
  differenceRow(pixels);
  ImGui::EndTable();
}

}  // namespace

void drawInspector(PanelContext& context) {
  float const size = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({size, size}, ImGuiCond_FirstUseEver);
  constexpr auto flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("Inspector", &context.state.inspectorShown, flags)) {
    if (context.cursorOnPicture)
      ImGui::Text("pixel %d, %d", context.cursorX, context.cursorY);
    else
      ImGui::TextDisabled("Point at the picture.");
    drawTable(context, std::floor(size * 7 / float(magnified)) * float(magnified));
    ImGui::TextDisabled("linear radiance, W/(sr m^2)");
  }
  ImGui::End();
}

}  // namespace ropelight::view
