#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/arguments/scene_options.h"

namespace ropelight {

/// `ropelight render`: a scene to image files without a window.
struct RenderOptions {
  SceneOptions scene;
  std::vector<std::string> outputs{"out.png"};  ///< .png (tone-mapped) or .exr (linear)
  std::uint64_t iterations = 0;                 ///< 0: no limit, or 64 where there is no time limit either
  double time = 0;                              ///< seconds of wall clock; 0: no limit
  std::string json;                             ///< file for the statistics, "-" for standard output, empty for none
  bool quiet = false;
};

/// Returns the exit code. Throws Error.
int runRender(const RenderOptions& options);

}  // namespace ropelight
