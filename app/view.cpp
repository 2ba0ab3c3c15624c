#include "app/view.h"

#include <fmt/format.h>

#include "app/scene_path.h"
#include "render/core/error.h"

namespace ropelight {

int runView(const ViewOptions& options) {
  std::string const scene = findScene(options.scene.scene);
  throw Error(fmt::format("the viewer is not built yet; render to a file: ropelight render {} -o out.png", scene),
              ExitCode::noDevice);
}

}  // namespace ropelight
