#pragma once
// A scene as flat lists of primitives in world space, in double, before a backend rounds them to its own scalar.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight {

/// Axis-aligned bounds; empty where min > max.
struct Bounds {
  Vec3d min{1e300};
  Vec3d max{-1e300};

  void grow(Vec3d p);
  void grow(const Bounds& b);
  void clip(const Bounds& b);
  bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
  Vec3d extent() const { return max - min; }
  double area() const;  ///< surface area; 0 where empty
  bool overlaps(const Bounds& b) const;
};

struct FlatQuad {
  Vec3d corner[4];
};

/// The image of the unit sphere under x ↦ toWorld·x + center.
struct FlatSphere {
  Mat3d toWorld{1.0};
  Vec3d center{0.0};
};

struct FlatTriangle {
  Vec3d a, b, c;
};

/// A diffuse emitter: one quad (a box is six) or one ellipsoid.
struct FlatLight {
  std::uint32_t primitive = 0;
  Rgb radiance{0.0f};
  Side side = Side::out;
  double area = 0;   ///< of one side
  double power = 0;  ///< mean over the channels of π·L·area·sides, watts
};

/// Primitives are numbered quads first, then spheres, then triangles.
struct FlatScene {
  std::vector<FlatQuad> quads;
  std::vector<FlatSphere> spheres;
  std::vector<FlatTriangle> triangles;
  std::vector<std::uint32_t> material;  ///< by primitive
  std::vector<std::int32_t> light;      ///< by quad and sphere; −1: none
  std::vector<FlatLight> lights;
  std::vector<MaterialDesc> materials;
  double diffuseArea = 0;  ///< of one side of every diffuse primitive
  Bounds bounds;
  double reach = 0;  ///< reachOf the bounds and the camera, or more

  std::uint32_t primitiveCount() const;
  Bounds primitiveBounds(std::uint32_t primitive) const;
  /// Whether the primitive's surface may meet the box; never false where it does. Spheres are tested by surface, so
  /// that a room-sized one does not sit in every cell.
  bool overlapsSurface(std::uint32_t primitive, const Bounds& box) const;
};

/// Largest distance along an axis between any two of: the bounds, the position, the origin.
double reachOf(const Bounds& bounds, Vec3d position);

/// Throws Error where numbers leave the range of float or there are more than 2³⁰ primitives.
FlatScene flatten(const Scene& scene);

/// Surface area of the ellipsoid that a linear map makes of the unit sphere: S = 4π R_G(a²b², a²c², b²c²), with R_G by
/// Carlson's duplication (Carlson 1995, "Numerical computation of real or complex elliptic integrals").
double ellipsoidArea(const Mat3d& toWorld);

/// Singular values of a 3×3 matrix, largest first.
Vec3d singularValues(const Mat3d& m);

/// What the scene alone needs; settings are added in prepare.cpp.
FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera);

}  // namespace ropelight
