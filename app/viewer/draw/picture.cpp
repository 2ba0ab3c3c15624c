#include "app/viewer/draw/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "app/viewer/draw/display_cuda.h"
#include "app/viewer/draw/false_colour.h"
#include "app/viewer/draw/picture_copy.h"

namespace ropelight::view {
namespace {

constexpr std::size_t bytesOf(int width, int height) {
  return std::size_t(width) * std::size_t(height) * 4 * sizeof(float);
}

std::unique_ptr<PixelPath> makePath(int gpu, bool allowInterop) {
  std::string why = "--no-interop";
  if (allowInterop || gpu < 0)
    if (auto path = makeInteropPath(gpu, why)) return path;
  return std::make_unique<CopyPath>(why);
}

}  // namespace

int otherImage(const ViewState& state) { return state.compare.withReference ? reference : estimateB; }

bool compares(const ViewState& state) {
  return state.compare.layout != Layout::single && (state.compare.withReference || state.compare.enabled);
}

bool needsImage(int which, const ViewState& state) {
  if (which == estimateA) return true;
  if (which == estimateB && !state.compare.enabled) return false;
  return state.inspectorShown || (compares(state) && which == otherImage(state));
}

Picture::Picture(int gpu, bool allowInterop) : program_("picture"), path_(makePath(gpu, allowInterop)) {}

Filled Picture::fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write) {
  Filled filled = path_->fill(buffer, bytes, write);
  if (filled == Filled::failed && !dynamic_cast<CopyPath*>(path_.get())) {
    path_ = std::make_unique<CopyPath>(fmt::format("interop failed ({})", path_->problem()));
    filled = path_->fill(buffer, bytes, write);
  }
  if (filled == Filled::failed) problem_ = path_->problem();
  return filled;
}

void Picture::update(PixelSource& source, const std::array<EstimateStatus, 3>& estimates,
                     const ReferenceStatus& referenceStatus, const ViewState& state) {
  problem_.clear();
  cpuTime_.begin();
  for (int which : {estimateA, estimateB, reference}) {
    auto const i = std::size_t(which);
    if (!needsImage(which, state)) {
      if (images_[i].texture) images_[i] = {}, uploadTimes_[i] = {};
    } else if (which == reference) {
      updateReference(referenceStatus);
    } else if (estimates[i].ready) {
      updateEstimate(which, source, estimates[i]);
    }
  }
  cpuTime_.end();
}

bool Picture::fits(int width, int height) {
  int const most = maxTextureSize();
  if (width <= most && height <= most) return true;
  problem_ =
      fmt::format("a picture of {} x {} pixels is not shown: this GL takes at most {} x {}", width, height, most, most);
  return false;
}

/// From `pixels`, or from the image's buffer where null.
bool Picture::uploadPixels(ImageOnGpu& image, int width, int height, const float* pixels) {
  if (!image.texture) image.texture.emplace();
  if (!image.texture->resize(width, height)) {
    problem_ = fmt::format("GL has no memory for a picture of {} x {} pixels", width, height);
    image = {};
    return false;
  }
  if (!pixels) {
    upload_(*image.buffer, *image.texture);
    return true;
  }
  glBindTexture(GL_TEXTURE_2D, image.texture->name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, pixels);
  glBindTexture(GL_TEXTURE_2D, 0);
  return true;
}

void Picture::updateEstimate(int which, PixelSource& source, const EstimateStatus& status) {
  ImageOnGpu& image = images_[std::size_t(which)];
  if (image.version == status.pixelVersion || status.width <= 0 || status.height <= 0) return;
  if (!fits(status.width, status.height)) return;
  if (!image.buffer) image.buffer.emplace();
  GpuTimer& timer = uploadTimes_[std::size_t(which)];
  int width = 0, height = 0;
  std::uint64_t iterations = 0;
  std::size_t const capacity = bytesOf(status.width, status.height);
  timer.begin();
  Filled const filled = fill(*image.buffer, capacity, [&](void* to) {
    return source.copyPixels(which, to, capacity, width, height, iterations);
  });
  if (filled == Filled::done && uploadPixels(image, width, height, nullptr)) {
    image.version = status.pixelVersion;
    image.iterations = iterations;
  }
  timer.end();
}

void Picture::updateReference(const ReferenceStatus& status) {
  ImageOnGpu& image = images_[std::size_t(reference)];
  if (!status.image || status.image->pixels.empty()) {
    image = {};
    return;
  }
  if (image.version == status.version || !fits(status.image->width, status.image->height)) return;
  std::vector<float> pixels;
  pixels.reserve(status.image->pixels.size() * 4);
  for (Rgb p : status.image->pixels) pixels.insert(pixels.end(), {p.r, p.g, p.b, 1.0f});
  if (uploadPixels(image, status.image->width, status.image->height, pixels.data())) image.version = status.version;
}

int Picture::width(int which) const {
  const auto& texture = images_[std::size_t(which)].texture;
  return texture ? texture->width() : 0;
}
int Picture::height(int which) const {
  const auto& texture = images_[std::size_t(which)].texture;
  return texture ? texture->height() : 0;
}

std::vector<float> Picture::readAround(int which, int x, int y, int n) {
  int const w = width(which), h = height(which);
  if (w == 0 || h == 0 || width(estimateA) == 0 || height(estimateA) == 0) return {};
  int const left = int((x + 0.5) * w / width(estimateA)) - n / 2;
  int const top = int((y + 0.5) * h / height(estimateA)) - n / 2;
  int const x0 = std::max(left, 0), x1 = std::min(left + n, w), y0 = std::max(top, 0), y1 = std::min(top + n, h);
  std::vector<float> around(std::size_t(n) * std::size_t(n) * 4, std::numeric_limits<float>::quiet_NaN());
  if (x0 >= x1 || y0 >= y1) return around;
  GlFramebuffer const framebuffer;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                         images_[std::size_t(which)].texture->name(), 0);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ROW_LENGTH, n);
  glReadPixels(x0, y0, x1 - x0, y1 - y0, GL_RGBA, GL_FLOAT,
               around.data() + (std::ptrdiff_t(y0 - top) * n + (x0 - left)) * 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return around;
}

std::vector<float> Picture::pixelBuffer(int which) const {
  const ImageOnGpu& image = images_[std::size_t(which)];
  if (!image.buffer || image.version == 0) return {};
  std::vector<float> pixels(std::size_t(width(which)) * std::size_t(height(which)) * 4);
  glBindBuffer(GL_COPY_READ_BUFFER, image.buffer->name());
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0, GLsizeiptr(pixels.size() * sizeof(float)), pixels.data());
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  return pixels;
}

DisplayTimes Picture::times() const {
  DisplayTimes times;
  for (const GpuTimer& timer : uploadTimes_) times.upload += timer.milliseconds();
  times.draw = drawTime_.milliseconds();
  times.cpu = cpuTime_.milliseconds();
  return times;
}

}  // namespace ropelight::view
