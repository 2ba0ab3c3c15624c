#pragma once
// What is drawn over A's picture, through A's camera: photons as points, the kd-tree's cells as lines.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/viewer/draw/picture.h"
#include "app/viewer/gl/gl.h"
#include "app/viewer/session/renderer.h"
#include "app/viewer/state/pixel_source.h"
#include "app/viewer/state/view_state.h"

namespace ropelight::view {

/// What the overlay's shaders need of a camera. Positions are taken relative to the camera before anything else, its
/// own position being split into two floats, so that scenes far from the origin do not jitter.
struct OverlayCamera {
  std::array<float, 3> positionHigh{}, positionLow{};
  std::array<float, 3> right{}, up{}, forward{};  ///< dot products with them give clip coordinates x, y and w
  float near = 0;                                 ///< scene units along the view direction
};

/// Agrees with makeCamera of render/camera/camera.h for a film of that shape.
OverlayCamera overlayCamera(const CameraDesc& camera, int width, int height);

class Overlay {
 public:
  /// Throws Error (internal) where the shaders fail.
  Overlay();

  /// Copies A's photons and cells to the GPU where the state shows them, and frees what it does not show.
  void update(PixelSource& source, Picture& picture, const EstimateStatus& status, const ViewState& state);
  /// Over the picture as its latest draw() left it. `camera` is that of the pixels shown, `scale` that of point sizes.
  void draw(const Picture& picture, const CameraDesc& camera, const ViewState& state, int framebufferHeight,
            float scale);

 private:
  void updatePoints(PixelSource& source, Picture& picture, const EstimateStatus& status, std::uint32_t most);
  void updateCells(const EstimateStatus& status, const TreeOverlay& tree);
  float meanFlux() const;
  void drawPoints(const OverlayCamera& camera, const PhotonOverlay& photons, float scale);
  void drawCells(const OverlayCamera& camera, const TreeOverlay& tree);

  GlProgram pointProgram_, lineProgram_;
  GlVertexArray vertices_;
  std::optional<GlBuffer> points_, lines_;
  std::uint64_t photonVersion_ = 0;
  std::uint32_t pointCount_ = 0;
  float meanFlux_ = 1;  ///< of the largest channel, watts
  std::shared_ptr<const KdTree> tree_;
  TreeOverlay cellsOf_;
  std::size_t cellCount_ = 0;
};

}  // namespace ropelight::view
