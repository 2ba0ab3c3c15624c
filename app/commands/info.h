#pragma once

#include <string>

#include "app/arguments/scene_options.h"

namespace ropelight {

/// `ropelight info`: what a scene needs, what is left out, and the memory it takes on the chosen backend.
struct InfoOptions {
  SceneOptions scene;
  bool kernels = false;  ///< say what each kernel takes of the GPU; then a scene may be missing
  std::string json;      ///< file, "-" for standard output instead of the text, empty for none
};

/// Returns the exit code. Throws Error.
int runInfo(const InfoOptions& options);

}  // namespace ropelight
