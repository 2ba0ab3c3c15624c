#include "app/arguments/scene_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "render/core/error.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

std::vector<std::string> assetNames(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path assetsFolder() {
  std::error_code failed;
  fs::path const program = fs::read_symlink("/proc/self/exe", failed);
  fs::path const installed = program.parent_path().parent_path() / "share" / "ropelight" / "assets";
  if (!failed && fs::is_directory(installed, failed)) return installed;
  return ROPELIGHT_ASSETS;
}

std::string findScene(const std::string& given) {
  if (isFile(given)) return given;
  if (fs::path(given).has_parent_path())
    throw Error(fmt::format("{}: there is no such scene file; check the path", given));
  fs::path const folder = assetsFolder();
  for (const char* extension : {"", ".json"})
    if (fs::path const asset = folder / (given + extension); isFile(asset)) return asset.string();
  std::vector<std::string> const names = assetNames(folder);
  throw Error(fmt::format("{}: there is no such scene file here or in {}{}; give a path or one of: {}", given,
                          folder.string(), suggestion(given, names), joinNames(names)));
}

}  // namespace ropelight
