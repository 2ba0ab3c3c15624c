#pragma once
// Intel Embree 3 on the same triangles: what this project's own BVHs are compared with. Optional.

#include <limits>
#include <memory>

#include "render/flat/flat_scene.h"

namespace ropelight {

/// Points are origin + t·direction for t in (0, tMax].
struct EmbreeRay {
  float origin[3];
  float direction[3];
  float tMax = std::numeric_limits<float>::infinity();
};

/// primitive: as FlatScene numbers it, 0xFFFFFFFF where nothing was hit; t is then the ray's tMax.
struct EmbreeHit {
  float t;
  std::uint32_t primitive;
};

/// Rays may be traced from any number of threads at once.
class EmbreeScene {
 public:
  /// Whether Embree was built in.
  static bool supported();

  /// Of a scene of triangles alone; quads and spheres are left out. robust: no ray slips between triangles that share
  /// an edge. Threads: 0: all cores. Throws Error where Embree is not built in or fails.
  EmbreeScene(const FlatScene& scene, bool robust, int threads = 0);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  double buildSeconds() const;
  EmbreeHit closest(const EmbreeRay& ray) const;
  bool occluded(const EmbreeRay& ray) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ropelight
