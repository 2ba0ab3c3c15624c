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
ToneSettings toneOf(const std::string& aov, ToneSettings tone, const ViewScale& scale) {
  tone.exposure = 0;
  tone.curve = Curve::linear;
  double const radius = scale.firstRadius > 0 ? scale.firstRadius : scale.distance / 100;
  if (aov == "depth") return scaled(tone, 0, 2 * scale.distance, false);
  if (aov == "traversal") return scaled(tone, 0, 64, false);
  if (aov == "tests") return scaled(tone, 0, 64, false);
  if (aov == "photon-count") return scaled(tone, 1, 1000, true);
  if (aov == "gather-radius") return scaled(tone, radius / 10, radius * 2, true);
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
  if (settings.aov != preset.aov || (*preset.mode && settings.mode != preset.mode)) return false;
  if (settings.aov != "radiance") return true;
  if (settings.indirectOnly != preset.indirectOnly) return false;
  return settings.mode != "sppm" || (settings.direct == preset.direct && photonView == preset.photons);
}

}  // namespace

void adaptTone(ViewState& state, ViewMemory& memory, const std::string& before, const ViewScale& scale) {
  std::string const& now = edited(state).aov;
  if (now == before) return;
  if (before == "radiance") memory.tone = state.tone;
  if (now != "radiance") {
    state.tone = toneOf(now, state.tone, scale);
  } else if (memory.tone) {
    state.tone = *memory.tone;
  } else if (state.tone.curve == Curve::falseColour) {
    state.tone.curve = Curve::linear;
  }
}

void applyPreset(ViewState& state, ViewMemory& memory, const Preset& preset, const ViewScale& scale) {
  Settings& settings = edited(state);
  std::string const before = settings.aov;
  if (*preset.mode) settings.mode = preset.mode;
  settings.aov = preset.aov;
  if (settings.mode == "sppm") settings.direct = preset.direct;
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
