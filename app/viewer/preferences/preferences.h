#pragma once
// What the window keeps between runs, as JSON in the user's configuration folder.

#include <filesystem>

#include "app/viewer/camera/camera_control.h"
#include "app/viewer/state/view_state.h"

namespace ropelight::view {

struct Preferences {
  ViewState state;  ///< kept of it: tone, compare's layout, overlays, panels, recent; not the settings
  std::vector<SavedView> views;
  double speed = 1;
  int width = 1280, height = 800;  ///< of the window
};

/// $XDG_CONFIG_HOME/ropelight/viewer.json, else ~/.config/ropelight/viewer.json; empty where neither is known.
std::filesystem::path preferencesFile();

/// Missing file: defaults. A damaged one, or values of the wrong type or out of range: defaults for those, and
/// `problem` says which. Never throws for what a file holds.
Preferences loadPreferences(const std::filesystem::path& file, std::string& problem);

/// Written whole or not at all. Throws Error where it cannot be written.
void savePreferences(const std::filesystem::path& file, const Preferences& preferences);

/// A settings file of "save settings": every value of Settings::params by name.
void saveSettings(const std::filesystem::path& file, const Settings& settings);
/// Throws Error (badInput) naming file, key and what was expected.
Settings loadSettings(const std::filesystem::path& file);

}  // namespace ropelight::view
