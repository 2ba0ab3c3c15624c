#include "app/viewer/gl/capture.h"

#include <algorithm>
#include <cstddef>

#include "app/viewer/gl/gl.h"
#include "render/image_files/png.h"

namespace ropelight::view {

Screenshot captureScreen(int width, int height) {
  if (width <= 0 || height <= 0) return {};
  Screenshot shot{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 3)};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, shot.bytes.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  std::ptrdiff_t const row = std::ptrdiff_t(width) * 3;
  for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom)  // GL's first row is the lowest
    std::swap_ranges(shot.bytes.begin() + top * row, shot.bytes.begin() + (top + 1) * row,
                     shot.bytes.begin() + bottom * row);
  return shot;
}

void saveScreenshot(const std::filesystem::path& path, const Screenshot& screenshot) {
  writeScreenPng(path, screenshot.width, screenshot.height, screenshot.bytes);
}

}  // namespace ropelight::view
