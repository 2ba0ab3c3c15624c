#pragma once
// Everything that a person sets in the window, apart from camera and scene: plain data that the panel edits, the main
// loop applies and preferences.cpp keeps between runs.

#include <array>
#include <string>
#include <vector>

#include "app/viewer/state/view_choices.h"
#include "render/settings/settings.h"

namespace ropelight::view {

/// Estimates by index.
inline constexpr int estimateA = 0, estimateB = 1, reference = 2;

struct ToneSettings {
  Curve curve = Curve::linear;
  float exposure = 0;      ///< stops
  float falseLow = 0.01f;  ///< of the false colour's scale; of the channels' mean
  float falseHigh = 10;
  bool falseLogarithmic = true;
  bool markNonFinite = true;  ///< magenta and black checks

  bool operator==(const ToneSettings&) const = default;
};

struct CompareSettings {
  bool enabled = false;  ///< estimate B exists
  Layout layout = Layout::single;
  float split = 0.5f;          ///< share of the picture that A has
  float gain = 1;              ///< of the difference
  float flickerHz = 2;         ///< swaps per second
  bool withReference = false;  ///< the right side is the reference, not B
  bool accumulateReference = false;
};

struct PhotonOverlay {
  bool shown = false;
  float size = 2;         ///< pixels
  float brightness = 0;   ///< stops
  int fewestBounces = 1;  ///< edges from the light
  int mostBounces = 32;
  bool global = true;
  bool caustic = true;
  int most = 200000;  ///< points drawn
};

struct TreeOverlay {
  bool shown = false;
  int depth = 8;             ///< cells down to this level
  bool onlyDeepest = false;  ///< leave out the cells above it
};

struct ViewState {
  std::array<Settings, 2> settings;  ///< of A and B
  int edited = estimateA;            ///< whose settings the panel shows
  ToneSettings tone;
  CompareSettings compare;
  PhotonOverlay photons;
  TreeOverlay tree;
  float imageBrightness = 1;  ///< of the picture under the overlays, [0, 1]
  bool paused = false;
  bool matchWindow = false;  ///< the film takes the size of the picture's place in the window
  bool stageTimes = false;   ///< measure stages on a GPU too
  bool panelShown = true;
  bool helpShown = false;
  bool inspectorShown = false;
  bool plotShown = true;
  std::vector<std::string> recent;  ///< scene files, latest first
};

}  // namespace ropelight::view
