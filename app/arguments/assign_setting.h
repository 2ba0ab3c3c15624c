#pragma once
// One setting from text.

#include <string>

#include "render/settings/settings.h"

namespace ropelight {

/// Sets one value of the params list by its name. Throws Error (usage); for an unknown key it lists those there are.
void assignSetting(Settings& settings, const std::string& key, const std::string& text);

}  // namespace ropelight
