#pragma once
// What the parts of the panel share.

#include <string>

#include "app/viewer/panel/panel.h"
#include "app/viewer/preferences/presets.h"

namespace ropelight::view {

/// A collapsible part, marked "header/<name>", and a smaller one within it, marked "group/<name>".
bool partHeader(const char* name, bool open);
bool subHeader(const std::string& name, bool open);

/// A button marked `mark`, of the given width (0: as its label needs, −1: what is left).
bool markedButton(const char* label, const char* mark, const char* tip = "", float width = 0);
/// A checkbox marked `mark`.
bool markedCheckbox(const char* label, const char* mark, bool& value, const char* tip = "");
/// Width of each of `count` buttons that share what is left of the line.
float buttonWidth(int count);

/// Wrapped: red, and grey.
void problemText(const std::string& text);
void quietText(const std::string& text);

ViewScale viewScale(const PanelContext& context);

/// The two halves of drawDisplay.
void drawTone(PanelContext& context);
void drawOverlays(PanelContext& context);

/// The table of stages with its history, a part of drawStatistics.
void drawStages(PanelContext& context, const EstimateStatus& status);

/// The file that a save button writes: the name in Files, and an ending such as ".png".
std::string savedFile(const PanelContext& context, const char* ending);

/// After focusPathBox() and until the box has the focus.
bool pathBoxWanted();

}  // namespace ropelight::view
