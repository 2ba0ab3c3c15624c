#pragma once
// Where in a cell a primitive's surface lies ('perfect' splits: Havran & Bittner 2002, "On Improving KD-Trees for Ray
// Shooting"; Wald & Havran 2006).

#include "accel/kdtree/builder/item.h"
#include "render/flat/flat_scene.h"

namespace ropelight {

/// Low, high.
struct KdParts {
  KdItem item[2];
  bool present[2];
};

/// A cell holds every primitive whose surface comes within padding() of it, measured along each axis.
class KdClipper {
 public:
  /// clip: cut polygons to cells; else only their bounds. The scene must outlive the clipper.
  KdClipper(const FlatScene& scene, bool clip);

  /// 2⁻²⁰ of the scene's reach: plane parameters are rounded three times in traversal and coordinates once.
  double padding() const { return padding_; }
  KdItem whole(std::uint32_t primitive) const;
  /// An item of the cell in the two halves of the cell, its bounds shrunk to what each holds of it. Conservative under
  /// rounding.
  KdParts divide(const KdItem& item, const KdBox& cell, int axis, float position) const;

 private:
  Bounds padded(const KdBox& cell) const;
  KdBox padded(const Bounds& surface) const;
  void dividePolygon(const KdBox& cell, int axis, float position, KdParts& parts) const;

  const FlatScene& scene_;
  bool clip_;
  double padding_;
  double margin_;  ///< the padding and more than the rounding of any number of cuts, about 2⁻⁵⁰ of the reach each
};

}  // namespace ropelight
