// The second half of Picture: places the layouts, and draws them.

#include <cmath>

#include "app/viewer/draw/false_colour.h"
#include "app/viewer/draw/picture.h"

namespace ropelight::view {
namespace {

constexpr float ground = 0.09f;  ///< grey around the pictures
constexpr int gap = 4;           ///< between two pictures, pixels

/// The shader's layouts.
enum ShaderLayout { leftAlone, rightAlone, splitBoth, difference };

}  // namespace

/// Fills sides_ for this frame.
void Picture::place(const Rect& whole, const ViewState& state, double seconds) {
  sides_ = {};
  int const other = otherImage(state);
  Layout const layout = compares(state) ? state.compare.layout : Layout::single;
  if (layout == Layout::sideBySide) {
    int const half = std::max((whole.width - gap) / 2, 0);
    Rect const left{whole.x, whole.y, half, whole.height};
    Rect const right{whole.x + whole.width - half, whole.y, half, whole.height};
    Rect const a = letterbox(left, width(estimateA), height(estimateA));
    Rect const b = letterbox(right, width(other), height(other));
    sides_ = {{{a, a, estimateA}, {b, b, other}}};
    return;
  }
  Rect const picture = letterbox(whole, width(estimateA), height(estimateA));
  sides_[0] = {picture, picture, estimateA};
  if (!shown(other)) return;
  if (layout == Layout::flicker && std::fmod(std::floor(seconds * double(state.compare.flickerHz)), 2.0) != 0)
    sides_[0].image = other;
  if (layout == Layout::split) {
    int const share = int(std::lround(double(picture.width) * std::clamp(double(state.compare.split), 0.0, 1.0)));
    sides_[0].visible.width = share;
    sides_[1] = {picture, {picture.x + share, picture.y, picture.width - share, picture.height}, other};
  }
}

void Picture::draw(const Rect& whole, int framebufferHeight, const ViewState& state, double seconds) {
  cpuTime_.begin();
  drawTime_.begin();
  place(whole, state, seconds);
  glDisable(GL_SCISSOR_TEST);
  Look const look = lookOf(whole, state);
  unchanged_ = look == latest_ ? unchanged_ + 1 : 0;
  latest_ = look;
  if (unchanged_ < 2) cache_.drop();
  if (!whole.empty() && !cache_.restore(whole, framebufferHeight)) {
    drawPictures(whole, framebufferHeight, state);
    if (unchanged_ >= 1) cache_.keep(whole, framebufferHeight);  // a picture that changes every frame is not copied
  }
  drawTime_.end();
  cpuTime_.end();
  cpuTime_.endFrame();
}

Picture::Look Picture::lookOf(const Rect& whole, const ViewState& state) const {
  Look look{whole,
            sides_[0].visible,
            sides_[1].visible,
            {},
            state.tone,
            Layout::single,
            sides_[0].image,
            otherImage(state),
            state.compare.split,
            state.compare.gain,
            state.imageBrightness};
  if (compares(state)) look.layout = state.compare.layout;
  for (std::size_t k = 0; k < images_.size(); ++k) look.versions[k] = images_[k].version;
  return look;
}

void Picture::drawPictures(const Rect& whole, int framebufferHeight, const ViewState& state) {
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_SCISSOR_TEST);
  clearGround(whole, framebufferHeight);
  glScissor(whole.x, whole.bottom(framebufferHeight), whole.width, whole.height);
  program_.use();
  setTone(state);
  glBindVertexArray(noVertices_.name());
  Layout const layout = compares(state) ? state.compare.layout : Layout::single;
  drawSide(0, layout, framebufferHeight, state);
  if (layout == Layout::sideBySide) drawSide(1, layout, framebufferHeight, state);
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
}

/// Leaves out where a lone picture will be, since on some GPUs filling costs as much as drawing.
void Picture::clearGround(const Rect& whole, int framebufferHeight) const {
  glClearColor(ground, ground, ground, 1.0f);
  auto const clear = [&](const Rect& r) {
    if (r.empty()) return;
    glScissor(r.x, r.bottom(framebufferHeight), r.width, r.height);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  const Rect& p = sides_[0].picture;
  bool const alone = sides_[1].picture.empty() || sides_[1].picture.x == p.x;
  if (!alone || p.empty() || !shown(sides_[0].image)) return clear(whole);
  clear({whole.x, whole.y, whole.width, p.y - whole.y});
  clear({whole.x, p.y + p.height, whole.width, whole.y + whole.height - p.y - p.height});
  clear({whole.x, p.y, p.x - whole.x, p.height});
  clear({p.x + p.width, p.y, whole.x + whole.width - p.x - p.width, p.height});
}

void Picture::drawSide(int side, Layout layout, int framebufferHeight, const ViewState& state) {
  const SideRects& rects = sides_[std::size_t(side)];
  int const other = otherImage(state);
  if (rects.picture.empty() || !shown(rects.image)) return;
  bool const both = shown(other) && (layout == Layout::split || layout == Layout::difference);
  int const left = both ? int(estimateA) : rects.image, right = both ? other : rects.image;
  program_.set("layout_", both ? (layout == Layout::split ? splitBoth : difference) : leftAlone);
  for (int unit : {1, 0}) {
    int const which = unit == 0 ? left : right;
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, images_[std::size_t(which)].texture->name());
    bool const nearest = rects.picture.width >= width(which);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    program_.set(unit == 0 ? "left" : "right", unit);
    program_.set(unit == 0 ? "leftSize" : "rightSize", std::array{float(width(which)), float(height(which))});
    program_.set(unit == 0 ? "leftScale" : "rightScale", float(rects.picture.width) / float(width(which)));
  }
  program_.set("size", std::array{float(rects.picture.width), float(rects.picture.height)});
  glViewport(rects.picture.x, rects.picture.bottom(framebufferHeight), rects.picture.width, rects.picture.height);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void Picture::setTone(const ViewState& state) {
  const ToneSettings& tone = state.tone;
  program_.set("curve", int(tone.curve));
  program_.set("exposure", std::exp2(tone.exposure));
  program_.set("markNonFinite", int(tone.markNonFinite));
  program_.set("brightness", state.imageBrightness);
  program_.set("split", state.compare.split);
  program_.set("lineWidth", 2.0f);
  program_.set("gain", state.compare.gain);
  bool const logarithmic = tone.falseLogarithmic;
  float const low = logarithmic ? std::log2(std::max(tone.falseLow, 1e-37f)) : tone.falseLow;
  float const high = logarithmic ? std::log2(std::max(tone.falseHigh, 1e-37f)) : tone.falseHigh;
  program_.set("falseLogarithmic", int(logarithmic));
  program_.set("falseLow", low);
  program_.set("falseScale", 1.0f / std::max(high - low, 1e-30f));
  program_.set("ramp", std::span<const std::array<float, 3>>(falseColourPoints));
}

bool Picture::placeAt(double x, double y, double& pictureX, double& pictureY) const {
  for (const SideRects& side : sides_) {
    if (!side.visible.contains(x, y)) continue;
    pictureX = (x - side.picture.x) / side.picture.width;
    pictureY = (y - side.picture.y) / side.picture.height;
    return true;
  }
  return false;
}

bool Picture::pixelAt(double x, double y, int& pixelX, int& pixelY) const {
  double placeX = 0, placeY = 0;
  if (width(estimateA) == 0 || height(estimateA) == 0 || !placeAt(x, y, placeX, placeY)) return false;
  pixelX = std::clamp(int(placeX * width(estimateA)), 0, width(estimateA) - 1);
  pixelY = std::clamp(int(placeY * height(estimateA)), 0, height(estimateA) - 1);
  return true;
}

}  // namespace ropelight::view
