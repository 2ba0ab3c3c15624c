#pragma once
// Moves the camera: pure arithmetic in double, no window.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/bounds.h"
#include "render/scene/scene.h"

namespace ropelight::view {

struct SavedView {
  std::string name;
  CameraDesc camera;
};

/// The camera is always one that validateScene takes: a move that would leave its limits stops there or is left out,
/// and so is one by numbers that are not finite. focusDistance 0 stays 0: sharp at the target, wherever that goes.
class CameraControl {
 public:
  /// Where reset() leads; `bounds` of the scene set the scale of the speed. Keeps the saved views.
  void setHome(const CameraDesc& home, const Bounds& bounds);
  void reset();

  const CameraDesc& camera() const { return camera_; }
  /// Repairs a camera that cannot make a picture, such as an up along the view; ignores a camera that is not finite.
  void setCamera(const CameraDesc& camera);

  /// Takes the camera right and up around the target, by angles in radians; stops short of the poles of its up vector.
  void orbit(double right, double up);
  /// Moves camera and target in the picture's plane; 1 is the picture's height at the target's distance.
  void pan(double right, double up);
  /// Multiplies the distance to the target by exp(−amount); never reaches it.
  void dolly(double amount);
  /// Turns right and up around the camera's own place, radians; the distance to the target stays.
  void look(double right, double up);
  /// Moves camera and target: each component in [−1, 1] along right, up and forward, for `seconds` at `speed`.
  void fly(Vec3d direction, double seconds);

  /// Full vertical angle in degrees, clamped to what a scene may hold.
  void setFov(double degrees);
  void setAperture(double radius);
  void setFocusDistance(double distance);
  /// Looks at the middle of the bounds from the same direction, so that all of it is seen. aspect: width over height.
  void frame(const Bounds& bounds, double aspect);

  /// Unit direction through a point of the picture, (0,0) its top left and (1,1) its bottom right corner.
  Vec3d directionThrough(double x, double y, double aspect) const;

  double speed = 1;  ///< diagonals of the scene's bounds per 5 seconds
  std::vector<SavedView> views;

 private:
  void translate(Vec3d offset);
  void accept(Vec3d position, Vec3d target);
  double leastDistance(Vec3d target) const;

  CameraDesc home_, camera_;
  double scale_ = 1;  ///< diagonal of the scene's bounds
};

/// The camera as the "camera" object of a scene file, ready to paste; every number is read back to the same bits.
std::string cameraJson(const CameraDesc& camera);

}  // namespace ropelight::view
