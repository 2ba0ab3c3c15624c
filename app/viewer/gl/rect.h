#pragma once
// A rectangle of the framebuffer in pixels, from its top left corner.

#include <algorithm>

namespace ropelight::view {

struct Rect {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Rect&) const = default;
  bool empty() const { return width <= 0 || height <= 0; }
  bool contains(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
  /// Its lower edge counted from the framebuffer's bottom, as GL does.
  int bottom(int framebufferHeight) const { return framebufferHeight - y - height; }
};

/// The largest rectangle of a picture's shape in the middle of `place`, at least a pixel large; empty where either is.
inline Rect letterbox(const Rect& place, int width, int height) {
  if (place.empty() || width <= 0 || height <= 0) return {place.x, place.y, 0, 0};
  double const scale = std::min(double(place.width) / width, double(place.height) / height);
  int const w = std::clamp(int(width * scale + 0.5), 1, place.width);
  int const h = std::clamp(int(height * scale + 0.5), 1, place.height);
  return {place.x + (place.width - w) / 2, place.y + (place.height - h) / 2, w, h};
}

}  // namespace ropelight::view
