#pragma once
// What a PNG file says about its colours.

#include <filesystem>
#include <string>

namespace ropelight {

struct PngColour {
  double gamma = 0;     ///< of gAMA: sample = linear^gamma; 0 where sRGB is to be taken
  std::string ignored;  ///< what else the file says and readPng ignores, separated by "; "; empty: nothing
};

/// Reads the chunks before the image data: gAMA, unless sRGB is there, which takes precedence (PNG 3rd edition, §4.3);
/// iCCP, cICP and cHRM are only named. Chunks that are damaged, of a wrong length or cut short count as absent and are
/// named. Never throws: a missing file, or one that is not a PNG, says nothing.
PngColour readPngColour(const std::filesystem::path& path);

}  // namespace ropelight
