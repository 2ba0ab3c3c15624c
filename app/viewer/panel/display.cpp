// How the film is shown, and what is drawn over it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/draw/false_colour.h"
#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/widgets/number_entry.h"
#include "app/viewer/widgets/param_widgets.h"

namespace ropelight::view {
namespace {

constexpr double widest = 1e30;

ImU32 legendColour(float t) {
  auto const colour = falseColour(t);
  return ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1});
}

void drawRamp(ImVec2 low, ImVec2 high) {
  constexpr int pieces = 56;  // a multiple of the ramp's seven parts
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (int i = 0; i < pieces; ++i) {
    float const from = float(i) / pieces, to = float(i + 1) / pieces;
    float const left = low.x + from * (high.x - low.x), right = low.x + to * (high.x - low.x);
    ImU32 const a = legendColour(from), b = legendColour(to);
    list->AddRectFilledMultiColor({left, low.y}, {right, high.y}, a, b, b, a);
  }
  list->AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
}

// The ramp with its low, middle and high values under it.
void drawLegend(const ToneSettings& tone) {
  ImVec2 const low = ImGui::GetCursorScreenPos();
  float const width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight();
  drawRamp(low, {low.x + width, low.y + line});
  bool const logarithmic = tone.falseLogarithmic && tone.falseLow > 0;
  double const middle = logarithmic ? std::sqrt(double(tone.falseLow) * double(tone.falseHigh))
                                    : (double(tone.falseLow) + double(tone.falseHigh)) / 2;
  double const values[] = {double(tone.falseLow), middle, double(tone.falseHigh)};
  for (int i = 0; i < 3; ++i) {
    std::string const text = fmt::format("{:.3g}", values[i]);
    float const left = low.x + float(i) / 2 * (width - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::GetWindowDrawList()->AddText({left, low.y + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  }
  ImGui::Dummy({width, 2 * line + ImGui::GetStyle().ItemSpacing.y});
}

// Where the two ends cross, moves the one that the user did not move.
void keepOrdered(ToneSettings& tone, bool lowMoved) {
  constexpr float least = 1e-30f;
  tone.falseHigh = std::max(tone.falseHigh, 10 * least);
  if (tone.falseLogarithmic) tone.falseLow = std::max(tone.falseLow, least);
  if (tone.falseHigh > tone.falseLow) return;
  if (lowMoved)
    tone.falseHigh = tone.falseLow * 10;
  else
    tone.falseLow = tone.falseHigh / 10;
}

void drawFalseColour(PanelContext& context) {
  ToneSettings& tone = context.state.tone;
  bool const logarithmic = tone.falseLogarithmic;
  bool const lowMoved = editParam("tone", "low", tone.falseLow,
                                  {.doc = "value that is black", .min = 0, .max = widest, .logarithmic = logarithmic});
  bool const highMoved = editParam("tone", "high", tone.falseHigh,
                                   {.doc = "value that is white", .min = 0, .max = widest, .logarithmic = logarithmic});
  bool const scaleMoved = editParam("tone", "logarithmic", tone.falseLogarithmic, {.doc = "equal ratios, not steps"});
  if (lowMoved || highMoved || scaleMoved) keepOrdered(tone, lowMoved);
  rowLabel("scale", {.doc = "of the mean of the channels"});
  if (markedButton("auto range", "tone/auto", "fit the scale to the film", -1)) context.actions.automaticRange = true;
  drawLegend(tone);
}

void drawPhotonOverlay(PhotonOverlay& photons) {
  editParam("photons", "shown", photons.shown, {.doc = "stored photons as points (P); they are there in mode sppm"});
  if (!photons.shown) return;
  editParam("photons", "size", photons.size, {.doc = "of a point", .min = 1, .max = 32, .unit = "pixels", .high = 16});
  editParam("photons", "brightness", photons.brightness,
            {.doc = "of their flux", .min = -60, .max = 60, .unit = "stops", .low = -10, .high = 20});
  editParam("photons", "fewest-bounces", photons.fewestBounces,
            {.doc = "edges from the light; 1: direct light", .min = 1, .max = 1024, .low = 1, .high = 32});
  editParam("photons", "most-bounces", photons.mostBounces,
            {.doc = "edges from the light", .min = 1, .max = 1024, .low = 1, .high = 32});
  photons.mostBounces = std::max(photons.mostBounces, photons.fewestBounces);
  editParam("photons", "global", photons.global,
            {.doc = "photons that met a diffuse surface before, or came directly"});
  editParam("photons", "caustic", photons.caustic, {.doc = "photons that came by specular bounces alone"});
  editParam(
      "photons", "most", photons.most,
      {.doc = "points drawn, evenly chosen", .min = 1, .max = 1e8, .low = 1000, .high = 4e6, .logarithmic = true});
}

void drawTreeOverlay(PanelContext& context) {
  TreeOverlay& tree = context.state.tree;
  editParam("tree", "shown", tree.shown, {.doc = "cells of the kd-tree as boxes (K)"});
  if (!tree.shown) return;
  if (!context.estimates[std::size_t(context.state.edited)].tree) quietText("This estimate has no kd-tree.");
  editParam("tree", "depth", tree.depth, {.doc = "cells down to this level", .min = 0, .max = 64, .high = 32});
  editParam("tree", "only-deepest", tree.onlyDeepest, {.doc = "leave out the cells above that level"});
}

}  // namespace

void drawTone(PanelContext& context) {
  ToneSettings& tone = context.state.tone;
  editParam("tone", "curve", tone.curve,
            {.doc = "from radiance to the screen; the film stays as it is (T)", .choices = choicesOf<Curve>});
  editParam("tone", "exposure", tone.exposure,
            {.doc = "radiance is multiplied by 2 to this power (+, -)",
             .min = -100,
             .max = 100,
             .unit = "stops",
             .low = -10,
             .high = 10});
  if (tone.curve == Curve::falseColour) drawFalseColour(context);
  editParam("tone", "mark-non-finite", tone.markNonFinite, {.doc = "NaN and infinity as magenta and black checks"});
  editParam("film", "match-window", context.state.matchWindow,
            {.doc = "the film takes the size of the picture's place in the window"});
}

void drawOverlays(PanelContext& context) {
  quietText("Photons");
  drawPhotonOverlay(context.state.photons);
  quietText("Cells of the kd-tree");
  drawTreeOverlay(context);
  quietText("Picture");
  editParam("picture", "brightness", context.state.imageBrightness,
            {.doc = "of the picture under the overlays", .min = 0, .max = 1});
}

void drawDisplay(PanelContext& context) {
  drawTone(context);
  drawOverlays(context);
}

}  // namespace ropelight::view
