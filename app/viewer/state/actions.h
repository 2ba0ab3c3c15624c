#pragma once
// What the panel and the keys ask for and the main loop does, once, after the frame in which they were asked.

#include <optional>
#include <string>
#include <vector>

namespace ropelight::view {

struct Actions {
  std::vector<std::string> open;         ///< scene or image files, by what their names end in
  std::string savePng, saveExr;          ///< picture of the film
  std::string saveCamera, saveSettings;  ///< JSON
  std::string screenshot;                ///< PNG of the whole window
  bool copyCamera = false;               ///< as scene JSON to the clipboard
  bool reset = false;                    ///< accumulation starts again
  int steps = 0;                         ///< iterations although paused
  bool resetCamera = false;
  bool frameAll = false;
  bool frameSelection = false;
  bool saveView = false;
  std::optional<int> restoreView;
  bool copySettingsToOther = false;  ///< of the edited estimate to the other one
  bool clearReference = false;
  bool automaticRange = false;  ///< false colour's scale from the film
  bool quit = false;
};

}  // namespace ropelight::view
