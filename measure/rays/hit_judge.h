#pragma once
// Whether an answer to a ray can be right, by double precision: for meshes too large to test every triangle.

#include <span>

#include "measure/streams/ray_stream.h"

namespace ropelight {

class HitJudge {
 public:
  /// Of a scene of triangles, seen as floats round them. Lengths within 2⁻¹⁸ of the scene's reach count as equal.
  explicit HitJudge(const FlatScene& scene);

  /// Whether the hit lies on its triangle and none of the candidates is clearly hit before it. A hit that grazes an
  /// edge or a plane may be taken or not.
  bool acceptable(const StreamRay& ray, const StreamHit& answer, std::span<const StreamHit> candidates) const;

 private:
  FlatTriangle triangle(std::uint32_t primitive) const;
  bool liesOn(const StreamRay& ray, const StreamHit& hit) const;
  /// Where the ray clearly crosses the triangle; infinity where it does not, or not clearly.
  double crossing(const StreamRay& ray, std::uint32_t primitive) const;

  const FlatScene& scene_;
  double tolerance_;
};

}  // namespace ropelight
