#include "app/viewer/gl/frame_cache.h"

namespace ropelight::view {

void FrameCache::keep(const Rect& place, int framebufferHeight) {
  drop();
  if (place.empty()) return;
  if (!texture_) texture_.emplace();
  if (!framebuffer_) framebuffer_.emplace();
  if (!texture_->resize(place.width, place.height, GL_RGBA8)) return;
  glBindTexture(GL_TEXTURE_2D, texture_->name());
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, place.x, place.bottom(framebufferHeight), place.width, place.height);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_->name());
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_->name(), 0);
  kept_ = glCheckFramebufferStatus(GL_READ_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  place_ = place;
}

bool FrameCache::restore(const Rect& place, int framebufferHeight) {
  if (!kept_ || !(place == place_)) return false;
  int const bottom = place.bottom(framebufferHeight);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_->name());
  glBlitFramebuffer(0, 0, place.width, place.height, place.x, bottom, place.x + place.width, bottom + place.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return true;
}

}  // namespace ropelight::view
