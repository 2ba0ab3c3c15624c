#pragma once
// What every subcommand that renders has in common.

#include <string>

#include "render/integrators/integrator.h"
#include "render/settings/settings.h"

namespace ropelight {

struct SceneOptions {
  std::string scene;  ///< as given; findScene() turns it into a path
  Settings settings;
  BackendChoice backend;
};

}  // namespace ropelight
