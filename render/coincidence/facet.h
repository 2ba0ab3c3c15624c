#pragma once
// Flat primitives and ellipsoids as the search for surfaces at the same place sees them.

#include "render/flat/flat_scene.h"

namespace ropelight {

/// A convex polygon, or an ellipsoid where it has no corners.
struct Facet {
  std::uint32_t primitive = 0, shape = 0;
  int corners = 0;
  Vec3d corner[4];
  Vec3d normal{0.0};  ///< unit length; of an ellipsoid: none
  FlatSphere sphere;
  double bound =
      0;            ///< error of a computed point along the normal, scene units; as in render/intersection/scene_view.h
  double size = 0;  ///< diagonal of the box
  Bounds box;

  bool curved() const { return corners == 0; }
};

Facet makeFacet(const FlatQuad& quad);
Facet makeFacet(const FlatTriangle& triangle);
Facet makeFacet(const FlatSphere& sphere);

/// How far apart two facets may lie and still count as one place for rays: twice the sum of their bounds, and no less
/// than what a float tells apart across the smaller, since bounds vanish in planes like y = 0.
double placeTolerance(const Facet& a, const Facet& b);

/// Whether two polygons lie in one plane, within the tolerance wherever the smaller is, and overlap by more than an
/// edge; or two ellipsoids have one surface. Polygons without a normal coincide with nothing.
bool coincide(const Facet& a, const Facet& b);

/// Whether a polygon covers another one that coincides with it, corners and all.
bool covers(const Facet& large, const Facet& small);

}  // namespace ropelight
