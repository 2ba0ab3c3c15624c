// The views of the menu.

#include "app/viewer/preferences/presets.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <string>

#include "app/viewer/draw/false_colour.h"

using namespace ropelight;
using namespace ropelight::view;

TEST_CASE("Every preset shows itself after it is applied, from every other one") {
  for (const Preset& from : presets)
    for (const Preset& to : presets) {
      ViewState state;
      ViewMemory memory;
      applyPreset(state, memory, from, {});
      applyPreset(state, memory, to, {});
      INFO(from.name, " -> ", to.name);
      REQUIRE(currentPreset(state));
      CHECK(std::string(currentPreset(state)->name) == to.name);
    }
}

TEST_CASE("Leaving a scalar view puts tone and brightness back") {
  ViewState state;
  ViewMemory memory;
  state.tone.curve = Curve::aces;
  state.tone.exposure = 1.5f;
  state.imageBrightness = 0.9f;
  ViewScale const scale{.distance = 8, .firstRadius = 0.1};
  for (const char* name : {"depth", "photons", "traversal heat", "gather count", "normals", "path"})
    for (const Preset& preset : presets)
      if (std::string(preset.name) == name) applyPreset(state, memory, preset, scale);
  CHECK(state.tone.curve == Curve::aces);
  CHECK(state.tone.exposure == 1.5f);
  CHECK(state.imageBrightness == 0.9f);
  CHECK_FALSE(state.photons.shown);
}

TEST_CASE("A scalar view has a scale from its scene") {
  ViewState state;
  ViewMemory memory;
  state.settings[0].aov = Aov::gatherRadius;
  adaptTone(state, memory, Aov::radiance, {.distance = 8, .firstRadius = 0.1});
  CHECK(state.tone.curve == Curve::falseColour);
  CHECK(state.tone.falseLow == doctest::Approx(0.01));
  CHECK(state.tone.falseHigh == doctest::Approx(0.2));
}

TEST_CASE("Custom settings are no preset") {
  ViewState state;
  state.settings[0].mode = Mode::sppm;
  state.settings[0].direct = DirectLight::photons;
  state.settings[0].indirectOnly = true;
  CHECK(currentPreset(state) == nullptr);
}

TEST_CASE("False colours go from black to white and stay there") {
  CHECK(falseColour(0) == std::array<float, 3>{0, 0, 0});
  CHECK(falseColour(-1) == falseColour(0));
  CHECK(falseColour(std::numeric_limits<float>::quiet_NaN()) == falseColour(0));
  CHECK(falseColour(1) == std::array<float, 3>{1, 1, 1});
  CHECK(falseColour(2) == falseColour(1));
}
