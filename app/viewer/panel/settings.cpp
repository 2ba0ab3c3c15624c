// The settings of the edited estimate, from Settings::params.

#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/preferences/presets.h"
#include "app/viewer/widgets/param_widgets.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

void drawTree(const Stats& stats) {
  if (stats.accel.empty()) return;
  if (stats.treeNodes == 0) {
    valueRow("rays test", "every primitive");
    return;
  }
  valueRow("built in", fmt::format("{:.1f} ms", stats.treeSeconds * 1e3));
  valueRow("nodes, leaves", fmt::format("{}, {}", stats.treeNodes, stats.treeLeaves));
  valueRow("depth reached", fmt::format("{}", stats.treeDepth));
  valueRow("SAH cost", fmt::format("{:.2f} primitive tests", stats.treeCost),
           "expected cost of a random line through the tree");
}

void drawState(const EstimateStatus& status) {
  if (!status.problem.empty()) problemText(status.problem);
  if (status.building)
    ImGui::TextDisabled("building...");
  else if (status.draft)
    ImGui::TextDisabled("draft while the camera moves");
}

}  // namespace

void drawSettings(PanelContext& context) {
  ViewState& state = context.state;
  Settings& settings = state.settings[std::size_t(state.edited)];
  const EstimateStatus& status = context.estimates[std::size_t(state.edited)];
  std::string const prefix = state.edited == estimateA ? "A" : "B";
  Settings resolved = status.ready ? status.stats.settings : Settings{};
  Aov const aov = settings.aov;

  drawState(status);
  for (const std::string& group : paramGroups(settings)) {
    if (!subHeader(group, group == "Mode" || group == "Photons")) continue;
    editGroup(prefix, group, settings, resolved);
    if (group == "Acceleration") drawTree(status.stats);
  }
  adaptTone(state, viewMemory(), aov, viewScale(context));
}

}  // namespace ropelight::view
