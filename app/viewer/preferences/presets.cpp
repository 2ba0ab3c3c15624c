#include "app/viewer/preferences/presets.h"

#include <algorithm>

namespace ropelight::view {
namespace {

constexpr float dimmed = 0.2f;  // brightness of the picture under the points of the photon view

Settings& edited(ViewState& state) { return state.settings[std::size_t(state.edited)]; }
const Settings& edited(const ViewState& state) { return state.settings[std::size_t(state.edited)]; }

bool isDimmed(const ViewState& state) { return state.photons.shown && state.imageBrightness <= 0.5f; }

ToneSettings scaled(ToneSettings tone, double low, double high, bool logarithmic) {
  tone.curve = Curve::falseColour;
  tone.falseLow = float(low);
  tone.falseHigh = float(high);
  tone.falseLogarithmic = logarithmic;
  return tone;
}

// Starting scales; 'automatic range' fits them to the film.
ToneSettings toneOf(Aov aov, ToneSettings tone, const ViewScale& scale) {
  tone.exposure = 0;
  tone.curve = Curve::linear;
  double const radius = scale.firstRadius > 0 ? scale.firstRadius : scale.distance / 100;
  switch (aov) {
    case Aov::depth:
      return scaled(tone, 0, 2 * scale.distance, false);
    case Aov::traversal:
    case Aov::tests:
      return scaled(tone, 0, 64, false);
    case Aov::photonCount:
      return scaled(tone, 1, 1000, true);
    case Aov::gatherRadius:
      return scaled(tone, radius / 10, radius * 2, true);
    case Aov::radiance:
    case Aov::normal:
    case Aov::albedo:
      break;
  }
  return tone;
}

void setPhotonView(ViewState& state, ViewMemory& memory, bool on) {
  if (on && !isDimmed(state)) {
    memory.brightness = state.imageBrightness;
    state.imageBrightness = dimmed;
  } else if (!on && isDimmed(state)) {
    state.imageBrightness = memory.brightness.value_or(1.0f);
    memory.brightness.reset();
  }
  state.photons.shown = on;
}

bool shows(const Preset& preset, const Settings& settings, bool photonView) {
  if (settings.aov != preset.aov || (preset.mode && settings.mode != *preset.mode)) return false;
  if (settings.aov != Aov::radiance) return true;
  if (settings.indirectOnly != preset.indirectOnly) return false;
  return settings.mode != Mode::sppm || (settings.direct == preset.direct && photonView == preset.photons);
}

}  // namespace

void adaptTone(ViewState& state, ViewMemory& memory, Aov before, const ViewScale& scale) {
  Aov const now = edited(state).aov;
  if (now == before) return;
  if (before == Aov::radiance) memory.tone = state.tone;
  if (now != Aov::radiance) {
    state.tone = toneOf(now, state.tone, scale);
  } else if (memory.tone) {
    state.tone = *memory.tone;
  } else if (state.tone.curve == Curve::falseColour) {
    state.tone.curve = Curve::linear;
  }
}

void applyPreset(ViewState& state, ViewMemory& memory, const Preset& preset, const ViewScale& scale) {
  Settings& settings = edited(state);
  Aov const before = settings.aov;
  if (preset.mode) settings.mode = *preset.mode;
  settings.aov = preset.aov;
  if (settings.mode == Mode::sppm) settings.direct = preset.direct;
  settings.indirectOnly = preset.indirectOnly;
  setPhotonView(state, memory, preset.photons);
  adaptTone(state, memory, before, scale);
}

const Preset* currentPreset(const ViewState& state) {
  bool const photonView = isDimmed(state);
  const Preset* const found = std::find_if(std::begin(presets), std::end(presets), [&](const Preset& preset) {
    return shows(preset, edited(state), photonView);
  });
  return found == std::end(presets) ? nullptr : found;
}

ViewMemory& viewMemory() {
  static ViewMemory memory;
  return memory;
}

}  // namespace ropelight::view
