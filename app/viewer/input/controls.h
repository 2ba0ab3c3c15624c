#pragma once
// Mouse and keys: what ImGui's input of a frame means for camera, state and actions, where no widget wants it.

#include <memory>

#include "app/viewer/camera/camera_control.h"
#include "app/viewer/draw/picture.h"
#include "app/viewer/preferences/presets.h"
#include "app/viewer/state/actions.h"
#include "app/viewer/state/view_state.h"

namespace ropelight::view {

/// What a frame's input acts on.
struct ControlTargets {
  ViewState& state;
  CameraControl& camera;
  Actions& actions;
  const Picture& picture;
  const Scene* scene = nullptr;  ///< null where none is shown
  double pixelRatio = 1;         ///< framebuffer pixels by window coordinate
  double seconds = 0;            ///< since the last frame
  ViewScale scale;               ///< for views that the keys choose
};

class Controls {
 public:
  /// Between ImGui's NewFrame and Render.
  void apply(const ControlTargets& targets);

  /// Index of the selected shape; −1: none.
  int selection() const { return selection_; }
  void clearSelection() { selection_ = -1; }
  /// What was selected or focused in this frame, in words; empty: nothing.
  const std::string& notice() const { return notice_; }

 private:
  void mouse(const ControlTargets& targets);
  void drag(const ControlTargets& targets);
  void point(const ControlTargets& targets, bool focus);
  void fly(const ControlTargets& targets);
  void keys(const ControlTargets& targets);
  void displayKeys(const ControlTargets& targets);
  void shortcuts(const ControlTargets& targets);

  int selection_ = -1;
  int dragged_ = -1;  ///< mouse button that went down on the picture
  bool splitDragged_ = false;
  std::string notice_;
};

/// The next layout, and the next tone curve, in menu order.
Layout nextLayout(Layout layout);
Curve nextCurve(Curve curve);

}  // namespace ropelight::view
