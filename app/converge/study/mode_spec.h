#pragma once
// What a study compares: modes, each with settings of its own.

#include <string>
#include <vector>

#include "render/settings/settings.h"

namespace ropelight {

struct ModeSpec {
  std::string label;  ///< as written
  Settings settings;
};

/// Reads "path,sppm,sppm:alpha=0.5:photons=65536": comma-separated modes, each the name of a Mode and settings after
/// colons, over those of `base`. gather=knn stands for gather=nearest; seed is that of the mode's first run. Throws
/// Error (usage) for an unknown mode or key, a value out of range, an empty or repeated entry.
std::vector<ModeSpec> parseModes(const std::string& text, const Settings& base);

/// The parts of text between separators; "" has one, empty.
std::vector<std::string> splitText(const std::string& text, char separator);

}  // namespace ropelight
