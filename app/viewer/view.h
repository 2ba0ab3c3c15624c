#pragma once

#include <cstdint>
#include <string>

#include "app/arguments/scene_options.h"

namespace ropelight {

/// `ropelight [view]`: the window.
struct ViewOptions {
  SceneOptions scene;
  bool watch = false;          ///< load the scene again when its files change
  std::uint64_t frames = 0;    ///< end after so many frames of one iteration each; 0: when the window is closed
  std::string screenshot;      ///< PNG of the whole window at the end; empty: none
  std::string state;           ///< JSON of what the window shows at the end; empty: none
  std::string script;          ///< file of input; empty: none
  std::string reference;       ///< .exr or .png to measure errors against; empty: none
  bool noInterop = false;      ///< never map GL buffers into CUDA
  double uiScale = 1;          ///< of text and spacing, beyond the monitor's own
  std::string window;          ///< "WIDTHxHEIGHT"; empty: as it was the last time
  bool noPreferences = false;  ///< neither read nor write what is kept between runs
};

/// Returns the exit code: 1 where a script could not go on. Throws Error: badInput for scene, reference or script,
/// noDevice without a display.
int runView(const ViewOptions& options);

}  // namespace ropelight
