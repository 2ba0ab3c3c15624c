#pragma once
// A command of an input script → what mouse and keyboard do in each of the next frames. No window.

#include <array>
#include <deque>
#include <string>

#include "app/viewer/input/script_parse.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {

/// Mouse and keyboard during one frame.
struct ScriptInput {
  float x = 0, y = 0;  ///< of the mouse, window coordinates
  std::array<bool, 3> buttons{};
  float wheel = 0;
  int key = -1;  ///< GLFW's number of the key that is down; −1: none
  bool shift = false, control = false, alt = false;
  std::string text;    ///< characters typed
  bool quick = false;  ///< part of a double click, which a slow frame must not stretch
};

/// Whether the command points at the widget that its word names.
bool pointsAtWidget(const ScriptCommand& command);
/// Whether it presses a mouse button.
bool pressesButton(const ScriptCommand& command);

/// The frames of a command, at least one. `held`: mouse and buttons as they are, and afterwards as the command leaves
/// them. place: of the widget, where the command points at one.
std::deque<ScriptInput> inputFrames(const ScriptCommand& command, const WidgetPlace& place, ScriptInput& held);

/// A turn of the wheel that brings a widget nearer that its panel's scrolling hides. windowHeight: where the mouse
/// works.
ScriptInput scrollTowards(const WidgetPlace& place, float windowHeight, const ScriptInput& held);

}  // namespace ropelight::view
