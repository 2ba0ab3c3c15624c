#pragma once
// A perspective camera with a thin lens. Image row 0 is at the top, column 0 at the left: right = forward × up.

#include "render/core/ray.h"
#include "render/core/warp.h"
#include "render/scene/scene.h"

namespace ropelight::RL_TARGET {

struct CameraView {
  Vec3 position{0}, forward{0, 0, -1};
  Vec3 right{1, 0, 0}, up{0, 1, 0};  ///< scaled: from the image's center to its edges, at unit distance
  Vec3 lensRight{0}, lensUp{0};      ///< scaled by the aperture's radius
  Real focusDistance = 1;
  bool thinLens = false;
  Real pixelX = 0, pixelY = 0;  ///< 2/width, 2/height

  /// Unit-direction ray through film position (x, y) in pixels from the top left corner; lens: uniform numbers.
  RL_HD Ray generate(Real x, Real y) const {
    Vec3 const d = forward + right * (x * pixelX - 1) + up * (1 - y * pixelY);
    return Ray{position, normalize(d), infinity};
  }

  RL_HD Ray generate(Real x, Real y, Vec2 lens) const {
    Vec3 const d = forward + right * (x * pixelX - 1) + up * (1 - y * pixelY);
    Vec2 const disc = concentricDisc(lens);
    Vec3 const offset = lensRight * disc.x + lensUp * disc.y;
    return Ray{position + offset, normalize(d * focusDistance - offset), infinity};
  }
};

inline CameraView makeCamera(const CameraDesc& c, int width, int height) {
  Vec3d const forward = glm::normalize(c.target - c.position);
  Vec3d const right = glm::normalize(glm::cross(forward, c.up));
  Vec3d const up = glm::cross(right, forward);
  double const tangent = std::tan(glm::radians(c.verticalFov) / 2);
  CameraView v;
  v.position = Vec3(c.position);
  v.forward = Vec3(forward);
  v.right = Vec3(right * (tangent * width / height));
  v.up = Vec3(up * tangent);
  v.lensRight = Vec3(right * c.apertureRadius);
  v.lensUp = Vec3(up * c.apertureRadius);
  v.thinLens = c.apertureRadius > 0;
  v.focusDistance = Real(c.focusDistance > 0 ? c.focusDistance : glm::length(c.target - c.position));
  v.pixelX = Real(2.0 / width);
  v.pixelY = Real(2.0 / height);
  return v;
}

}  // namespace ropelight::RL_TARGET
