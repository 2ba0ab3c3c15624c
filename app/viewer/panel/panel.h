#pragma once
// The Dear ImGui panel and the windows beside it.

#include <array>
#include <string>
#include <vector>

#include "app/viewer/camera/camera_control.h"
#include "app/viewer/gl/frame_timer.h"
#include "app/viewer/session/renderer.h"
#include "app/viewer/state/actions.h"
#include "app/viewer/state/view_state.h"

namespace ropelight::view {

/// What the panel shows and edits.
struct PanelContext {
  ViewState& state;
  CameraControl& camera;
  Actions& actions;
  std::array<EstimateStatus, 3> estimates;
  ReferenceStatus reference;
  std::string backend;      ///< which device and why
  std::string displayPath;  ///< "interop: …" or "copy: …", with the reason
  DisplayTimes displayTimes;
  double framesPerSecond = 0;
  std::string sceneName;
  std::vector<std::string> sceneNotes;  ///< Scene::notes
  std::string problem;                  ///< the latest failure to load or save; empty: none
  std::string notice;                   ///< the latest thing that was done, such as a file saved
  bool cursorOnPicture = false;
  int cursorX = 0, cursorY = 0;  ///< pixel of the film under the cursor
  /// Pixels around the cursor as they are in the textures: RGBA of A, B and the reference, rows from the top,
  /// `magnified` squared of them each, the cursor's in the middle; outside the film NaN alpha. Empty where there is no
  /// such image.
  std::array<std::vector<float>, 3> magnifier;
};

inline constexpr int magnified = 11;

/// Draws the main panel at the right edge of the window, over its full height, `width` pixels wide, and the help,
/// inspector and plot windows that the state asks for.
void drawPanel(PanelContext& context, float width);

/// The parts, each in its own file.
void drawSettings(PanelContext& context);    ///< settings.cpp: from Settings::params
void drawDisplay(PanelContext& context);     ///< display.cpp: tone, overlays
void drawCamera(PanelContext& context);      ///< camera.cpp
void drawCompare(PanelContext& context);     ///< compare.cpp
void drawStatistics(PanelContext& context);  ///< statistics.cpp: rates, stages, memory, features
void drawFiles(PanelContext& context);       ///< files.cpp
void focusPathBox();                         ///< the next drawFiles opens and asks for a path (Ctrl+O)
void drawErrorPlot(PanelContext& context);   ///< error_plot.cpp: log-log, a window of its own
void drawInspector(PanelContext& context);   ///< inspector.cpp: a window of its own
void drawHelp(PanelContext& context);        ///< help.cpp: a window of its own

}  // namespace ropelight::view
