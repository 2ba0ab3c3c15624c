#pragma once
// Scenes and images that come in, pictures and settings that go out.

#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/session/renderer.h"
#include "render/scene/scene.h"

namespace ropelight::view {

struct LoadedScene {
  std::shared_ptr<const Scene> scene;  ///< null where it failed
  std::string problem;
  bool again = false;  ///< the file that was shown before
};

/// Loads one scene at a time on a thread of its own; a later one waits for the earlier one.
class SceneLoader {
 public:
  ~SceneLoader();
  void start(const std::string& file, bool again);
  bool busy() const { return loading_.valid(); }
  /// The scene, once, when it is read.
  std::optional<LoadedScene> take();

 private:
  std::future<LoadedScene> loading_;
  std::string next_;  ///< asked for in the meantime; empty: none
};

/// Whether the name ends as an image's does.
bool isImageFile(const std::string& file);

/// "<scene>-<mode>-<iterations>" and the extension, in the working folder.
std::string pictureName(const Scene& scene, const Stats& stats, const char* extension);

/// Writes the estimate's film with its metadata, as PNG through this tone or as linear EXR by the name's ending.
/// Throws Error; also where there is no film yet.
void savePicture(const std::string& file, Renderer& renderer, int which, const ToneSettings& tone);

/// Sets the scale of the false colour to the first and last percentile of the film's channel means. False without one.
bool fitRange(ToneSettings& tone, const Image& film);

}  // namespace ropelight::view
