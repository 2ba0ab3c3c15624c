#pragma once
// The presets of the panel's view menu: each is a few settings of the edited estimate, the overlays that belong to it,
// and a tone curve that makes its numbers visible. Plain data, no window.

#include <optional>

#include "app/viewer/state/view_state.h"

namespace ropelight::view {

struct Preset {
  const char* name;
  const char* doc;
  std::optional<Mode> mode;  ///< empty: as it is
  Aov aov = Aov::radiance;
  DirectLight direct = DirectLight::shadow;
  bool indirectOnly = false;
  bool photons = false;  ///< shown as points over a dimmed picture
};

inline constexpr Preset presets[] = {
    {.name = "ray", .doc = "direct light and perfect reflection alone", .mode = Mode::ray},
    {.name = "path", .doc = "path tracing", .mode = Mode::path},
    {.name = "sppm", .doc = "photon mapping: direct light by shadow rays, indirect by photons", .mode = Mode::sppm},
    {.name = "indirect only", .doc = "what the photons alone bring", .mode = Mode::sppm, .indirectOnly = true},
    {.name = "direct by photons",
     .doc = "photons carry the direct light too",
     .mode = Mode::sppm,
     .direct = DirectLight::photons},
    {.name = "photons", .doc = "the stored photons as points", .mode = Mode::sppm, .photons = true},
    {.name = "traversal heat",
     .doc = "what a camera ray costs: cells visited and primitives tested",
     .mode = {},
     .aov = Aov::traversal},
    {.name = "gather count", .doc = "photons that a gather finds", .mode = Mode::sppm, .aov = Aov::photonCount},
    {.name = "gather radius", .doc = "radius of the gather", .mode = Mode::sppm, .aov = Aov::gatherRadius},
    {.name = "normals", .doc = "of the first hit", .mode = {}, .aov = Aov::normal},
    {.name = "depth", .doc = "distance to the first hit", .mode = {}, .aov = Aov::depth},
    {.name = "albedo", .doc = "of the first hit", .mode = {}, .aov = Aov::albedo},
};

/// Lengths from which the scale of a scalar view is set at first.
struct ViewScale {
  double distance = 1;     ///< from the camera to its target
  double firstRadius = 0;  ///< of the gather; 0: unknown
};

/// What the views changed, to be put back when they are left.
struct ViewMemory {
  std::optional<ToneSettings> tone;  ///< of radiance
  std::optional<float> brightness;   ///< of the picture without photons over it
};

void applyPreset(ViewState& state, ViewMemory& memory, const Preset& preset, const ViewScale& scale);

/// Gives the film of the edited estimate a tone that suits it, after its aov was `before`; radiance gets its own back.
void adaptTone(ViewState& state, ViewMemory& memory, Aov before, const ViewScale& scale);

/// The preset that the edited estimate shows; null where it is none of them.
const Preset* currentPreset(const ViewState& state);

/// The program's one memory, for the panel and the keys.
ViewMemory& viewMemory();

}  // namespace ropelight::view
