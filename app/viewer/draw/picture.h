#pragma once
// The pixels of A, B and the reference on the GPU, and the pass that shows them.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/draw/pixel_path.h"
#include "app/viewer/gl/frame_cache.h"
#include "app/viewer/gl/frame_timer.h"
#include "app/viewer/gl/gl.h"
#include "app/viewer/gl/rect.h"
#include "app/viewer/gl/upload.h"
#include "app/viewer/session/renderer.h"
#include "app/viewer/state/pixel_source.h"
#include "app/viewer/state/view_state.h"

namespace ropelight::view {

struct DisplayTimes;  // panel.h

class Picture {
 public:
  /// Pixels come from the memory of this GPU (−1: from host memory). Throws Error (internal) where the shaders fail.
  Picture(int gpu, bool allowInterop);

  /// Copies what changed into the textures that the state needs, and frees those that it does not need. Once a frame.
  void update(PixelSource& source, const std::array<EstimateStatus, 3>& estimates, const ReferenceStatus& reference,
              const ViewState& state);
  /// Draws into `place`, of a framebuffer of that height, the layout's pictures letterboxed on a dark ground. `seconds`
  /// drive the flicker. Scissor and viewport of the whole framebuffer are left for the next caller to set.
  void draw(const Rect& place, int framebufferHeight, const ViewState& state, double seconds);

  /// Where the picture on a side (0: A or the only one; 1: what A is compared with) lies, by the latest draw().
  Rect pictureRect(int side) const { return sides_[std::size_t(side)].picture; }
  /// The part of it that is not covered by the other side.
  Rect visibleRect(int side) const { return sides_[std::size_t(side)].visible; }
  /// The pixel of A's film under a place in the framebuffer, on whichever side; false off the pictures.
  bool pixelAt(double x, double y, int& pixelX, int& pixelY) const;
  /// The same as a place in the picture, (0,0) its top left and (1,1) its bottom right corner.
  bool placeAt(double x, double y, double& pictureX, double& pictureY) const;

  /// Width and height of an image's texture; 0 without one.
  int width(int which) const;
  int height(int which) const;
  /// Iterations that A's or B's texture holds.
  std::uint64_t iterations(int which) const { return images_[std::size_t(which)].iterations; }

  /// n·n RGBA values around pixel (x, y) of A's film as they are in another image's texture, from the top row, n odd;
  /// outside of it NaN in all four. Empty without a texture. Waits for the GPU.
  std::vector<float> readAround(int which, int x, int y, int n);
  /// The pixel buffer of A or B as GL has it: width·height RGBA, from the top row. Empty without one. Waits for the
  /// GPU.
  std::vector<float> pixelBuffer(int which) const;

  /// "interop: …" or "copy: …", with the reason.
  std::string describePath() const { return path_->describe(); }
  /// Why the latest pixels are not shown, such as a film larger than GL's textures; empty: they are.
  const std::string& problem() const { return problem_; }
  DisplayTimes times() const;
  /// For the overlay's buffers.
  PixelPath& path() { return *path_; }
  /// Fills a buffer by the current path; from the first failure on, by copying.
  Filled fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write);

 private:
  struct ImageOnGpu {
    std::optional<GlTexture> texture;
    std::optional<GlBuffer> buffer;  ///< none for the reference
    std::uint64_t version = 0;       ///< of the pixels in the texture; 0: none
    std::uint64_t iterations = 0;
  };
  struct SideRects {
    Rect picture, visible;
    int image = 0;
  };

  void updateEstimate(int which, PixelSource& source, const EstimateStatus& status);
  void updateReference(const ReferenceStatus& status);
  bool fits(int width, int height);
  bool uploadPixels(ImageOnGpu& image, int width, int height, const float* pixels);
  void clearGround(const Rect& place, int framebufferHeight) const;
  bool shown(int which) const { return images_[std::size_t(which)].version != 0; }
  void place(const Rect& place, const ViewState& state, double seconds);
  void drawSide(int side, Layout layout, int framebufferHeight, const ViewState& state);
  void setTone(const ViewState& state);

  /// All that the pixels of a frame depend on.
  struct Look {
    Rect place, left, right;
    std::array<std::uint64_t, 3> versions{};
    ToneSettings tone;
    Layout layout = Layout::single;
    int image = 0, other = 0;
    float split = 0, gain = 0, brightness = 0;
    bool operator==(const Look&) const = default;
  };
  Look lookOf(const Rect& place, const ViewState& state) const;
  void drawPictures(const Rect& place, int framebufferHeight, const ViewState& state);

  std::array<ImageOnGpu, 3> images_;
  std::array<SideRects, 2> sides_;
  GlProgram program_;
  Upload upload_;
  FrameCache cache_;
  Look latest_;
  int unchanged_ = 0;  ///< frames with the latest look
  GlVertexArray noVertices_;
  std::array<GpuTimer, 3> uploadTimes_;
  GpuTimer drawTime_;
  CpuTimer cpuTime_;
  std::string problem_;
  std::unique_ptr<PixelPath> path_;
};

/// Whether the layout compares A with another image, and with which: estimateB or reference.
bool compares(const ViewState& state);
int otherImage(const ViewState& state);
/// Whether the state shows this image anywhere, the inspector included.
bool needsImage(int which, const ViewState& state);

}  // namespace ropelight::view
