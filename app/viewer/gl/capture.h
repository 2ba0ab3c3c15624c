#pragma once
// The window's pixels as a file.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ropelight::view {

/// 8-bit RGB as the screen gets it, width·height·3 bytes, row 0 at the top.
struct Screenshot {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// The back buffer, before it is swapped. Waits for the GPU. Empty for a framebuffer without pixels.
Screenshot captureScreen(int width, int height);

/// As PNG, exactly these bytes. Throws Error as writeFile does, and for a screenshot without pixels.
void saveScreenshot(const std::filesystem::path& path, const Screenshot& screenshot);

}  // namespace ropelight::view
