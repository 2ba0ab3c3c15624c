#pragma once
// Where every widget of the panel lies in the window, by name: scripts and tests point at them as a person does.

#include <map>
#include <string>

namespace ropelight::view {

/// In window coordinates (those of the mouse), from the top left corner.
struct WidgetPlace {
  float left = 0, top = 0, right = 0, bottom = 0;
  int frame = 0;         ///< of ImGui, in which it was drawn last
  bool visible = false;  ///< not clipped away by its scrolled panel
};

/// Remembers the place of the ImGui item drawn last under this name ("A/photons", "tone/exposure", "compare/split" …).
void markWidget(const std::string& name);

/// All that were ever marked; those with the latest frame are there now.
const std::map<std::string, WidgetPlace>& widgetPlaces();

}  // namespace ropelight::view
