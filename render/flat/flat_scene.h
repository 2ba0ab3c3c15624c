#pragma once
// A scene as flat lists of primitives in world space, in double, before a backend rounds them to its own scalar.

#include <memory>
#include <vector>

#include "render/flat/layer.h"
#include "render/scene/bounds.h"
#include "render/scene/scene.h"

namespace ropelight {

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

struct FlatScene;

/// An instance: a mesh that is stored once, placed in the world. A hit on its triangle k has the number firstHit + k.
struct FlatInstance {
  std::uint32_t mesh = 0;  ///< index into FlatScene::meshes
  Mat4d toWorld{1.0};      ///< affine, from the mesh's space
  std::uint32_t firstHit = 0;
  Bounds bounds;     ///< exact, of the vertices in the world
  Vec3d slack{0.0};  ///< how far rounding may move it for rays, in units of 2⁻¹⁹ of the scene's reach
};

/// Coordinates are in a frame of the scene's own, moved by whole steps so that the scene lies near the origin, where
/// floats are dense: x_file = x_flat + origin. The step is a power of two, 2.8 to 5.7 times the scene's extent, so that
/// scenes within 1.4 times their extent of the origin are not moved, and moves by multiples of it change no bit.
/// Primitives are numbered quads first, then spheres, then triangles, then instances; a hit on an instance has a number
/// above all of them. The scene of an instanced mesh holds its triangles alone, centred and scaled by a power of two to
/// within [−1, 1]; rays are started within [−2, 2], which its reach covers wherever it is placed.
struct FlatScene {
  std::vector<FlatQuad> quads;
  std::vector<FlatSphere> spheres;
  std::vector<FlatTriangle> triangles;
  std::vector<FlatQuad> hiddenFaces;  ///< of solids that stand on something: left out, nothing can reach them
  std::vector<FlatInstance> instances;
  std::vector<std::shared_ptr<const FlatScene>> meshes;  ///< instanced
  std::vector<std::uint32_t> material;                   ///< by primitive; empty in an instanced mesh
  std::vector<std::int32_t> light;                       ///< by quad and sphere; −1: none
  std::vector<FlatLight> lights;
  std::vector<MaterialDesc> materials;
  std::vector<Layer> layers;  ///< by primitive; empty where no surfaces lie at the same place
  double diffuseArea = 0;     ///< of one side of every diffuse primitive
  Vec3d origin{0.0};          ///< of the frame, in the file's coordinates
  Bounds bounds;
  double reach = 0;  ///< reachOf the bounds and the camera, or more

  /// A camera of the file in the frame.
  CameraDesc inFrame(const CameraDesc& camera) const { return moved(camera, -origin); }

  std::uint32_t primitiveCount() const;
  /// All numbers that a hit may have are below: primitives, and the triangles of every instance.
  std::uint32_t hitCount() const;
  /// Quads and triangles are polygons; spheres and instances are not.
  bool isPolygon(std::uint32_t primitive) const;
  /// Of an instance with its slack.
  Bounds primitiveBounds(std::uint32_t primitive) const;
  /// Whether the primitive's surface may overlap the box; never false where it does. Spheres are tested by surface, so
  /// that a room-sized one does not sit in every cell; instances by their bounds.
  bool overlapsSurface(std::uint32_t primitive, const Bounds& box) const;
};

/// Largest distance along an axis between any two of: the bounds, the position, the frame's origin.
double reachOf(const Bounds& bounds, Vec3d position);

}  // namespace ropelight
