#pragma once
// Where a scene named on the command line lies.

#include <filesystem>
#include <string>

namespace ropelight {

/// The folder of the scenes that come with the program: beside an installed program, else in the source tree.
std::filesystem::path assetsFolder();

/// `given` if it exists; else, where it has no directory part, the asset of that name with or without ".json".
/// Throws Error (badInput) naming both places and the assets there are.
std::string findScene(const std::string& given);

}  // namespace ropelight
