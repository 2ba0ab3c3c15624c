#pragma once
// Sampling a parallelogram's area.

#include "render/scene/view.h"

namespace ropelight::RL_TARGET {

struct QuadLight {
  using Shape = Quad;

  /// A point uniform by area, on the outer side.
  RL_HD static void samplePoint(const Quad& quad, Vec2 u, Surface& out) { placeOn(quad, u.x, u.y, out); }

  /// A point that `from` may see, and its density per solid angle there; 0 where there is none.
  RL_HD static Real sampleToward(const Quad& quad, Real area, Vec3 from, Vec2 u, Surface& out) {
    placeOn(quad, u.x, u.y, out);
    return pdfToward(quad, area, from, out.p);
  }

  /// Density per solid angle of sampleToward for a point p of the light.
  RL_HD static Real pdfToward(const Quad& quad, Real area, Vec3 from, Vec3 p) {
    Vec3 const d = p - from;
    Real const distance2 = lengthSquared(d);
    Real const cosine = abs(dot(quad.n, d));  // times the distance
    return cosine > 0 ? distance2 * sqrt(distance2) / (cosine * area) : Real(0);
  }
};

}  // namespace ropelight::RL_TARGET
