#pragma once
// Scene files written for a test.

#include "tests/support/temporary_folder.h"

namespace ropelight {

/// Writes a file into the folder, or into a folder in it, and returns its path.
inline std::string writeFile(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  std::filesystem::path const path = folder / name;
  std::filesystem::create_directories(path.parent_path());
  putBytes(path, text);
  return path.string();
}

}  // namespace ropelight
