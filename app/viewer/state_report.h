#pragma once
// What the window shows, as JSON: tests and scripts assert on it.

#include <nlohmann/json.hpp>

#include "app/viewer/draw/picture.h"
#include "app/viewer/gl/window.h"
#include "app/viewer/panel/panel.h"

namespace ropelight::view {

struct FrameCounts {
  std::uint64_t frames = 0;
  double seconds = 0;        ///< since the window opened
  double slowestMs = 0;      ///< since the state was reported last
  double medianMs = 0;       ///< between frames, over the latest 120
  std::uint64_t scenes = 0;  ///< that have taken over
};

/// Reads pixel buffers back, so that it waits for the GPU.
nlohmann::ordered_json stateReport(const PanelContext& context, Picture& picture, const Window& window,
                                   const FrameCounts& counts, int selection);

}  // namespace ropelight::view
