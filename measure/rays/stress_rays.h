#pragma once
// Rays on which tracers fail, without end: along axes and in planes of a structure, from and through vertices and
// edges, tangent, from inside, from afar, with components from the smallest to the largest.

#include <random>
#include <vector>

#include "accel/kdtree/kd_tree.h"
#include "measure/streams/ray_stream.h"
#include "render/flat/flat_scene.h"

namespace ropelight {

class StressRays {
 public:
  /// Of a scene with at least one triangle; planes are those of the tree, where there is one.
  StressRays(const FlatScene& scene, const KdTree* tree, std::uint32_t seed);

  /// As many rays of all kinds, in turn. The same seed gives the same rays.
  std::vector<StreamRay> make(std::size_t count);
  /// Rays from within `radius` of the origin through vertices, through edges and in any direction.
  std::vector<StreamRay> makeInside(std::size_t count, double radius);

 private:
  using Kind = StreamRay (StressRays::*)();

  StreamRay scattered();
  StreamRay axisParallel();
  StreamRay fromAfar();
  StreamRay uneven();
  StreamRay inPlane();
  StreamRay fromVertex();
  StreamRay throughVertex();
  StreamRay acrossEdge();
  StreamRay alongEdge();
  StreamRay inTriangle();
  StreamRay fromSurface();

  double between(double low, double high) { return low + (high - low) * (double(engine_()) / 4294967296.0); }
  std::uint32_t below(std::size_t n) { return std::uint32_t(std::uint64_t(engine_()) * n >> 32); }
  Vec3d inBox(double scale);
  Vec3d direction();
  Vec3d alongAxes();
  const FlatTriangle& triangle();
  Vec3d vertex();
  StreamRay ray(Vec3d origin, Vec3d direction);

  const FlatScene& scene_;
  std::vector<KdNode> planes_;
  std::mt19937 engine_;
  Vec3d center_, half_;
};

}  // namespace ropelight
