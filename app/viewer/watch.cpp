#include "app/viewer/watch.h"

#include <algorithm>

namespace ropelight::view {
namespace {

namespace fs = std::filesystem;

constexpr double restInterval = 0.25;   // seconds between looks
constexpr double settleInterval = 0.1;  // seconds between looks at files that are being written

}  // namespace

/// Keeps the old stamp of a file that is missing, so that saving by deleting and renaming is one change and not two.
void Watch::look(const fs::path& path, Stamp& stamp) {
  std::error_code noSize, noTime;
  Stamp const found{fs::last_write_time(path, noTime), fs::file_size(path, noSize)};
  if (!noSize && !noTime) stamp = found;
}

void Watch::add(const std::string& file) {
  std::error_code error;
  fs::path const path = fs::absolute(file, error);  // the working directory may change
  if (file.empty() || error) return;
  if (std::any_of(files_.begin(), files_.end(), [&](const File& f) { return f.path == path; })) return;
  Stamp stamp;
  look(path, stamp);
  files_.push_back({path, stamp, stamp});
}

void Watch::start(const Scene& scene) {
  files_.clear();
  add(scene.file);
  for (const Mesh& mesh : scene.meshes) add(mesh.file);  // the loader has put the scene's folder before them
  nextLook_ = 0;
}

bool Watch::changed(double now) {
  if (!(now >= nextLook_)) return false;
  bool different = false, settled = true;
  for (File& file : files_) {
    Stamp const before = file.latest;
    look(file.path, file.latest);
    settled = settled && file.latest == before;
    different = different || file.latest != file.known;
  }
  nextLook_ = now + (different ? settleInterval : restInterval);
  if (!different || !settled) return false;
  for (File& file : files_) file.known = file.latest;
  return true;
}

}  // namespace ropelight::view
