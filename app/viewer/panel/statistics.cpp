// What the edited estimate has done, and what it cost.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/run/report.h"
#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/widgets/number_entry.h"
#include "app/viewer/widgets/param_widgets.h"
#include "render/core/features.h"

namespace ropelight::view {
namespace {

void drawDevice(const PanelContext& context) {
  valueRow("device", context.backend);
  valueRow("display", context.displayPath, "how the pixels get from the renderer into the window, and why so");
  const DisplayTimes& times = context.displayTimes;
  valueRow("cost of display",
           fmt::format("upload {:.2f} ms, draw {:.2f} ms, CPU {:.2f} ms", times.upload, times.draw, times.cpu),
           "medians over the latest frames");
  valueRow("frames", fmt::format("{:.1f} a second", context.framesPerSecond));
}

void drawRates(const Stats& stats) {
  valueRow("iterations", fmt::format("{} in {:.2f} s", stats.iterations, stats.seconds));
  valueRow("rate", fmt::format("{:.4g} iterations/s", iterationRate(stats)));
  valueRow("rays", fmt::format("{:.4g} M/s", megaRays(stats)), "closest-hit and shadow rays");
  if (stats.photonPaths == 0) return;
  valueRow("photons", fmt::format("{:.4g} M/s", megaPhotons(stats)), "photon paths emitted");
  double const each = double(stats.photonsStored) / double(std::max<std::uint64_t>(stats.iterations, 1));
  valueRow("stored", fmt::format("{:.0f} an iteration", each), "photons that met a diffuse surface");
  valueRow("gather radius",
           fmt::format("{} now, {} at first", shortNumber(stats.radius), shortNumber(stats.firstRadius)),
           "scene units");
  if (stats.firstCausticRadius > 0)
    valueRow(
        "of caustics",
        fmt::format("{} now, {} at first", shortNumber(stats.causticRadius), shortNumber(stats.firstCausticRadius)),
        "scene units");
}

// Counts that should be zero stand out where they are not.
void drawWarnings(const Stats& stats) {
  for (const std::string& advice : stats.advice) problemText(advice);
  if (stats.nonFinite > 0)
    problemText(
        fmt::format("{} samples were NaN or infinite and left out: {}", stats.nonFinite, nonFiniteStages(stats)));
  else
    valueRow("non-finite", "none", "samples that were NaN or infinite and left out");
  if (stats.truncatedPaths > 0)
    valueRow("truncated", fmt::format("{} paths", stats.truncatedPaths), "cut at the hard depth limit");
  if (stats.regrown > 0)
    valueRow("traced again", fmt::format("{} iterations", stats.regrown), "after the photon storage had grown");
}

void drawMemory(const Stats& stats) {
  std::uint64_t total = 0, most = 1;
  for (auto const& [purpose, bytes] : stats.bytes) {
    total += bytes;
    most = std::max(most, bytes);
  }
  for (auto const& [purpose, bytes] : stats.bytes) {
    rowLabel(purpose.c_str(), {});
    ImGui::ProgressBar(float(double(bytes) / double(most)), {-1, ImGui::GetTextLineHeight() + 2},
                       formatBytes(bytes).c_str());
  }
  valueRow("total", formatBytes(total));
}

void drawFeatures(const Stats& stats) {
  valueRow("kernel row", stats.kernelRow, "the row of render/launch/rows.h in use");
  std::string used, left;
  for (const FeatureName& feature : featureNames) {
    std::string& list = stats.features & feature.bit ? used : left;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", feature.what);
  }
  valueRow("compiled in", used.empty() ? "nothing" : used);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  valueRow("left out", left.empty() ? "nothing" : left, "what this scene and its settings do not need");
  ImGui::PopStyleColor();
}

}  // namespace

void drawStatistics(PanelContext& context) {
  const EstimateStatus& status = context.estimates[std::size_t(context.state.edited)];
  if (context.state.compare.enabled) quietText(context.state.edited == estimateA ? "Estimate A" : "Estimate B");
  drawDevice(context);
  for (const std::string& note : context.sceneNotes) problemText(note);
  if (!status.ready) return quietText("No iteration yet.");
  ImGui::Separator();
  drawRates(status.stats);
  drawWarnings(status.stats);
  if (subHeader("Stages", true)) drawStages(context, status);
  if (subHeader("Memory", false)) drawMemory(status.stats);
  if (subHeader("Features", false)) drawFeatures(status.stats);
}

}  // namespace ropelight::view
