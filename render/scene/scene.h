#pragma once
// The host's value type of a scene: what a loader fills, before anything is flattened for a backend.

#include <optional>
#include <string>
#include <vector>

#include "render/bsdf/bsdfs.h"
#include "render/core/params.h"
#include "render/core/vec.h"
#include "render/scene/mesh_report.h"
#include "render/scene/side.h"

namespace ropelight {

// What single precision can work with, with room for squares and areas.
inline constexpr double maxCoordinate = 1e14;  ///< scene units
inline constexpr double minExtent = 1e-15;     ///< scene units; of a shape's largest dimension
inline constexpr double maxRadiance = 1e15;    ///< W·sr⁻¹·m⁻²
inline constexpr double minFov = 0.001;        ///< degrees
inline constexpr double maxFov = 179.9;        ///< degrees
inline constexpr int maxFilmEdge = 65536;      ///< pixels
inline constexpr double maxFilmPixels = 1 << 28;
inline constexpr ParamInfo coordinateLimits{"coordinate", -maxCoordinate, maxCoordinate, "scene units"};

/// Thin-lens camera. Lengths in scene units, the angle in degrees.
struct CameraDesc {
  Vec3d position{0, 0, 5};
  Vec3d target{0, 0, 0};
  Vec3d up{0, 1, 0};
  double verticalFov = 45;    ///< full angle, degrees, in (0, 180)
  double apertureRadius = 0;  ///< 0: pinhole
  double focusDistance = 0;   ///< along the view direction; 0: distance to the target

  bool operator==(const CameraDesc&) const = default;
};

/// The same view with everything moved by an offset.
inline CameraDesc moved(CameraDesc camera, Vec3d offset) {
  camera.position += offset;
  camera.target += offset;
  return camera;
}

struct FilmDesc {
  int width = 512;   ///< pixels
  int height = 512;  ///< pixels
};

/// Diffuse emission: the same radiance (W·sr⁻¹·m⁻²) in all directions on a side.
struct Emission {
  Rgb radiance{1.0f};
  Side side = Side::out;
};

enum class ShapeKind : std::uint8_t {
  sphere,  ///< unit sphere around the origin; its outside is `out`
  box,     ///< [−1, 1]³; its outside is `out`
  quad,    ///< (0,0,0) (1,0,0) (1,1,0) (0,1,0); its normal, and `out`, is +z
  mesh,    ///< triangles; counter-clockwise seen from outside
};

/// Triangles by index into positions, in the mesh's own space.
struct Mesh {
  std::string file;
  std::vector<Vec3d> positions;
  std::vector<glm::uvec3> triangles;
  bool flipped = false;  ///< its triangles face the other way than in the file
  MeshReport report{};
};

struct NamedMaterial {
  std::string name;
  MaterialDesc desc;
};

/// One shape placed in the world by an affine transform (column vectors: world = toWorld · local).
struct ShapeDesc {
  ShapeKind kind = ShapeKind::sphere;
  std::string name;
  Mat4d toWorld{1.0};
  int material = 0;  ///< index into Scene::materials
  int mesh = -1;     ///< index into Scene::meshes, for ShapeKind::mesh alone
  std::optional<Emission> emission;
};

struct Scene {
  std::string name;
  std::string file;
  CameraDesc camera;
  FilmDesc film;
  std::vector<NamedMaterial> materials;
  std::vector<Mesh> meshes;
  std::vector<ShapeDesc> shapes;
  std::vector<std::string> notes;  ///< what was repaired, approximated or is doubtful; a line per file or shape
};

/// Refuses what no format may hold: no shapes, values that are not finite, a camera without a direction, shapes that
/// their transform flattens, indices of nothing. Throws Error (badInput) with the scene's file and a JSON pointer.
void validateScene(const Scene& scene);

}  // namespace ropelight
