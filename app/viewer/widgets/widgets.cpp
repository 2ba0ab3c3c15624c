#include "app/viewer/widgets/widgets.h"

#include <imgui.h>

namespace ropelight::view {
namespace {

std::map<std::string, WidgetPlace>& places() {
  static std::map<std::string, WidgetPlace> all;
  return all;
}

}  // namespace

void markWidget(const std::string& name) {
  ImVec2 const low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImVec2 const middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const ImDrawList* const list = ImGui::GetWindowDrawList();
  ImVec2 const clipLow = list->GetClipRectMin(), clipHigh = list->GetClipRectMax();
  // A pointer aims at the middle, so that is what must not be clipped away.
  bool const visible = middle.x >= clipLow.x && middle.x < clipHigh.x && middle.y >= clipLow.y && middle.y < clipHigh.y;
  places()[name] = {low.x, low.y, high.x, high.y, ImGui::GetFrameCount(), visible};
}

const std::map<std::string, WidgetPlace>& widgetPlaces() { return places(); }

}  // namespace ropelight::view
