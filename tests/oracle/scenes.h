#pragma once
// The scenes on which the renderer is held against the oracle.

#include "tests/oracle/oracle.h"

namespace oracle {

/// Room [−1, 1]³ without its front wall (+z), all diffuse: red left, green right; a block and a ball on the floor, a
/// square light of half-size 0.3 just below the ceiling.
Scene diffuseBox(int width, int height);

/// Open-fronted box with a mirror and a glass sphere under a light box: the scene of box-spheres-diffuse.exr.
Scene boxSpheresDiffuse(int width, int height);

/// Closed room [−1, 1] × [0, 2] × [−1, 1], water of index 1.33 up to y = 0.6, a square light under the ceiling that
/// faces down, the camera in the air above: all light on the floor is a caustic.
Scene pool(int width, int height);

/// Closed room [−1, 1] × [0, 2] × [−1, 1] with a glass block that stands this far above the floor and a lamp that hangs
/// as far below the ceiling. With 0 they lie at the same place, which the oracle itself cannot tell apart.
Scene touchingRoom(int width, int height, double gap);

}  // namespace oracle
