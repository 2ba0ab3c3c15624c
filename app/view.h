#pragma once

#include "app/scene_options.h"

namespace ropelight {

/// `ropelight [view]`: the window, of which this build has only the place.
struct ViewOptions {
  SceneOptions scene;
};

/// Throws Error: badInput where there is no such scene, else noDevice.
int runView(const ViewOptions& options);

}  // namespace ropelight
