#pragma once
// Notices that a scene, or a mesh that it uses, was written again.

#include <filesystem>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight::view {

class Watch {
 public:
  /// Watches the scene's file and the files of its meshes from now on.
  void start(const Scene& scene);
  /// True once after a change: size or time of a file differs, and was the same in two looks 100 ms apart, so that a
  /// half-written file is not loaded. A missing file is not a change. Cheap: looks every 250 ms, and every 100 ms while
  /// files are being written. now: seconds.
  bool changed(double now);

 private:
  struct Stamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  struct File {
    std::filesystem::path path;
    Stamp known;   ///< as loaded
    Stamp latest;  ///< in the latest look that found the file
  };
  static void look(const std::filesystem::path& path, Stamp& stamp);
  void add(const std::string& file);

  std::vector<File> files_;
  double nextLook_ = 0;
};

}  // namespace ropelight::view
