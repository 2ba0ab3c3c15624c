#pragma once
// A part of the window as it was drawn, put back while nothing in it changes: a software GL then copies pixels instead
// of running the display pass for every pixel of every frame.

#include <optional>

#include "app/viewer/gl/gl.h"
#include "app/viewer/gl/rect.h"

namespace ropelight::view {

class FrameCache {
 public:
  /// Takes the rectangle of the back buffer. A copy that GL has no memory for is not kept.
  void keep(const Rect& place, int framebufferHeight);
  /// Draws what was kept; false where nothing is.
  bool restore(const Rect& place, int framebufferHeight);
  void drop() { kept_ = false; }

 private:
  std::optional<GlFramebuffer> framebuffer_;
  std::optional<GlTexture> texture_;
  Rect place_;
  bool kept_ = false;
};

}  // namespace ropelight::view
