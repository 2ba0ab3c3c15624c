// Error against run time of both estimates, live, on logarithmic axes.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/plot/plot_math.h"
#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/session/error_curves.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

constexpr ImU32 curveColours[] = {IM_COL32(102, 187, 255, 255), IM_COL32(255, 170, 70, 255)};
constexpr ImU32 gridColour = IM_COL32(255, 255, 255, 20), decadeColour = IM_COL32(255, 255, 255, 52);
constexpr const char* curveNames[] = {"A", "B"};

struct Curve {
  std::vector<PlotPoint> points;
  std::optional<PowerLaw> law;
};

/// Where the axes lie in the window.
struct Plot {
  ImVec2 low, high;
  LogRange x, y;

  ImVec2 place(PlotPoint p) const {
    return {low.x + float(logPosition(x, p.x)) * (high.x - low.x),
            high.y - float(logPosition(y, p.y)) * (high.y - low.y)};
  }
};

std::array<Curve, 2> curvesOf(const PanelContext& context) {
  std::array<Curve, 2> curves;
  for (std::size_t i = 0; i < 2; ++i) {
    if (i == 1 && !context.state.compare.enabled) continue;
    curves[i].points = plottable(errorCurve(context.estimates[i]));
    curves[i].law = fitLastDecade(curves[i].points);
  }
  return curves;
}

Plot layOut(const std::array<Curve, 2>& curves, ImVec2 low, ImVec2 high) {
  std::vector<double> xs, ys;
  for (const Curve& curve : curves)
    for (PlotPoint p : curve.points) {
      xs.push_back(p.x);
      ys.push_back(p.y);
    }
  return {low, high, logRange(xs), logRange(ys, 0.08)};
}

void drawGrid(const Plot& plot) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  ImU32 const text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  float const line = ImGui::GetFontSize();
  list->AddRectFilled(plot.low, plot.high, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5f));
  for (const AxisTick& tick : logTicks(plot.x, std::max(2, int((plot.high.x - plot.low.x) / (5 * line))))) {
    float const x = plot.place({tick.value, plot.y.low}).x;
    list->AddLine({x, plot.low.y}, {x, plot.high.y}, tick.label.empty() ? gridColour : decadeColour);
    float const width = ImGui::CalcTextSize(tick.label.c_str()).x;
    list->AddText({x - width / 2, plot.high.y + line * 0.2f}, text, tick.label.c_str());
  }
  for (const AxisTick& tick : logTicks(plot.y, std::max(2, int((plot.high.y - plot.low.y) / (2 * line))))) {
    float const y = plot.place({plot.x.low, tick.value}).y;
    list->AddLine({plot.low.x, y}, {plot.high.x, y}, tick.label.empty() ? gridColour : decadeColour);
    float const width = ImGui::CalcTextSize(tick.label.c_str()).x;
    list->AddText({plot.low.x - width - line * 0.4f, y - line / 2}, text, tick.label.c_str());
  }
  list->AddRect(plot.low, plot.high, decadeColour);
}

void drawDashed(ImVec2 from, ImVec2 to, ImU32 colour) {
  float const dx = to.x - from.x, dy = to.y - from.y;
  float const dash = ImGui::GetFontSize() * 0.45f, length = std::hypot(dx, dy);
  if (!(length > 0) || length > 1e5f) return;
  for (float at = 0; at < length; at += 2 * dash) {
    float const a = at / length, b = std::min(at + dash, length) / length;
    ImGui::GetWindowDrawList()->AddLine({from.x + a * dx, from.y + a * dy}, {from.x + b * dx, from.y + b * dy}, colour);
  }
}

void drawCurve(const Plot& plot, const Curve& curve, ImU32 colour) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  float const size = ImGui::GetFontSize();
  bool const dotted = curve.points.size() <= 64;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    ImVec2 const here = plot.place(curve.points[i]);
    if (i > 0) list->AddLine(plot.place(curve.points[i - 1]), here, colour, size * 0.12f);
    if (dotted || i + 1 == curve.points.size()) list->AddCircleFilled(here, size * 0.2f, colour);
  }
  if (!curve.law) return;
  double const from = plot.x.low, to = plot.x.high;
  drawDashed(plot.place({from, curve.law->at(from)}), plot.place({to, curve.law->at(to)}), colour & 0x90FFFFFFu);
}

void drawLegend(const Plot& plot, const std::array<Curve, 2>& curves, const PanelContext& context) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  float const line = ImGui::GetFontSize();
  float y = plot.low.y + line * 0.5f;
  for (std::size_t i = 0; i < 2; ++i) {
    if (curves[i].points.empty()) continue;
    std::string text = fmt::format("{}: {}", curveNames[i], nameOf(context.state.settings[i].mode));
    if (curves[i].law) text += fmt::format(", slope {:.2f}", curves[i].law->exponent);
    float const left = plot.high.x - ImGui::CalcTextSize(text.c_str()).x - line * 0.6f;
    list->AddLine({left - line * 1.6f, y + line / 2}, {left - line * 0.4f, y + line / 2}, curveColours[i],
                  line * 0.15f);
    list->AddText({left, y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    y += line * 1.2f;
  }
}

void drawHover(const Plot& plot, const std::array<Curve, 2>& curves, const PanelContext& context) {
  ImVec2 const mouse = ImGui::GetMousePos();
  if (!ImGui::IsItemHovered()) return;
  float nearest = ImGui::GetFontSize() * 2;
  std::size_t which = 2;
  PlotPoint found;
  for (std::size_t i = 0; i < 2; ++i)
    for (PlotPoint p : curves[i].points) {
      ImVec2 const place = plot.place(p);
      float const distance = std::hypot(place.x - mouse.x, place.y - mouse.y);
      if (distance >= nearest) continue;
      nearest = distance;
      which = i;
      found = p;
    }
  if (which == 2) return;
  ImGui::GetWindowDrawList()->AddCircle(plot.place(found), ImGui::GetFontSize() * 0.4f, curveColours[which]);
  double iterations = 0;
  for (const ErrorPoint& error : context.estimates[which].errors)
    if (error.seconds == found.x) iterations = error.iterations;
  ImGui::SetTooltip("%s: relMSE %.4g\nafter %.4g s, %.0f iterations", curveNames[which], found.y, found.x, iterations);
}

void drawAxes(const PanelContext& context, const std::array<Curve, 2>& curves) {
  float const line = ImGui::GetFontSize();
  ImVec2 const corner = ImGui::GetCursorScreenPos(), space = ImGui::GetContentRegionAvail();
  ImVec2 const low{corner.x + line * 4.2f, corner.y + line * 1.3f};
  ImVec2 const high{corner.x + space.x - line * 0.8f, corner.y + space.y - line * 2.4f};
  if (high.x - low.x < line || high.y - low.y < line) return;
  Plot const plot = layOut(curves, low, high);
  ImU32 const text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  ImGui::GetWindowDrawList()->AddText({corner.x, corner.y}, text, "relMSE");
  const char* const xName = "seconds of run time";
  float const xWidth = ImGui::CalcTextSize(xName).x;
  ImGui::GetWindowDrawList()->AddText({(low.x + high.x - xWidth) / 2, high.y + line * 1.3f}, text, xName);
  drawGrid(plot);
  ImGui::GetWindowDrawList()->PushClipRect(low, high, true);
  for (std::size_t i = 0; i < 2; ++i) drawCurve(plot, curves[i], curveColours[i]);
  ImGui::GetWindowDrawList()->PopClipRect();
  drawLegend(plot, curves, context);
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton("##plot", {high.x - low.x, high.y - low.y});
  markWidget("plot");
  drawHover(plot, curves, context);
}

bool isWanted(const PanelContext& context) {
  return context.reference.present || context.reference.accumulating || context.state.compare.enabled;
}

}  // namespace

void drawErrorPlot(PanelContext& context) {
  if (!isWanted(context)) return;
  float const size = ImGui::GetFontSize();
  ImVec2 const display = ImGui::GetIO().DisplaySize;
  ImVec2 const start{std::clamp(display.x * 0.45f, size * 16, size * 34), size * 22};
  ImGui::SetNextWindowSize(start, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({size, std::max(display.y - start.y - size, 0.0f)}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Error against time", &context.state.plotShown, ImGuiWindowFlags_NoScrollbar)) {
    auto const curves = curvesOf(context);
    if (!context.reference.problem.empty()) problemText(context.reference.problem);
    if (curves[0].points.empty() && curves[1].points.empty())
      quietText(context.reference.present || context.reference.accumulating
                    ? "No error was measured yet."
                    : "Open a reference image (.exr), or accumulate one under Compare.");
    else
      drawAxes(context, curves);
  }
  ImGui::End();
}

}  // namespace ropelight::view
