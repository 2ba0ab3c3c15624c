#include "render/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "render/core/error.h"
#include "render/scene/bounds.h"
#include "render/scene/ellipsoid.h"
#include "render/scene/transform.h"

namespace ropelight {
namespace {

[[noreturn]] void fail(const Scene& scene, const std::string& place, const std::string& problem) {
  throw Error(fmt::format("{}: {}: {}", scene.file, place, problem));
}

// A room scaled by powers of ten: at 1e-10 iterations no longer end in time, at 1e13 the picture is another.
constexpr double minSceneSize = 1e-9, maxSceneSize = 1e12;  // scene units

bool within(double x, double low, double high) { return x >= low && x <= high; }  // false for NaN

bool isPoint(Vec3d p) {
  return within(p.x, -maxCoordinate, maxCoordinate) && within(p.y, -maxCoordinate, maxCoordinate) &&
         within(p.z, -maxCoordinate, maxCoordinate);
}

void validateCamera(const Scene& scene) {
  const CameraDesc& camera = scene.camera;
  auto check = [&](bool good, const char* key, const char* problem) {
    if (!good) fail(scene, std::string("/camera") + key, problem);
  };
  check(isPoint(camera.position), "/position", "expected finite coordinates of at most 1e14");
  check(isPoint(camera.target), "/target", "expected finite coordinates of at most 1e14");
  check(isPoint(camera.up), "/up", "expected finite coordinates of at most 1e14");
  check(within(camera.verticalFov, minFov, maxFov), "/fov", "expected degrees in [0.001, 179.9]");
  check(within(camera.apertureRadius, 0, maxCoordinate), "/aperture", "expected a radius of 0 or more");
  check(within(camera.focusDistance, 0, maxCoordinate), "/focus", "expected a distance of 0 or more");

  constexpr double leastAngle = 1e-6;  // radians between the view direction and up
  double const farthest = std::max(glm::length(camera.position), glm::length(camera.target));
  Vec3d const view = camera.target - camera.position;
  check(glm::length(view) > 1e-12 * farthest, "/target", "target and position coincide; move one of them");
  check(glm::length(camera.up) > 0, "/up", "expected a direction other than [0, 0, 0]");
  double const sine = glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.up)));
  check(sine > leastAngle, "/up", "up is parallel to the view direction; choose another up");
}

void validateFilm(const Scene& scene) {
  const FilmDesc& film = scene.film;
  if (!within(film.width, 1, maxFilmEdge) || !within(film.height, 1, maxFilmEdge) ||
      double(film.width) * film.height > maxFilmPixels)
    fail(scene, "/film",
         fmt::format("{} x {} pixels; expected edges in [1, 65536] and at most 2^28 pixels", film.width, film.height));
}

void validateMesh(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw Error(mesh.file + ": the mesh has no triangles");
  if (mesh.positions.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(mesh.file + ": the mesh has more than 2^32 - 1 vertices");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!isPoint(mesh.positions[i]))
      throw Error(fmt::format("{}: vertex {}: expected finite coordinates of at most 1e14", mesh.file, i + 1));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      if (mesh.triangles[i][corner] >= mesh.positions.size())
        throw Error(fmt::format("{}: triangle {} names vertex {} of {}", mesh.file, i + 1,
                                mesh.triangles[i][corner] + std::uint64_t{1}, mesh.positions.size()));
}

Vec3d corner(const Bounds& b, int i) {
  return Vec3d(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z);
}

Bounds localBounds(const ShapeDesc& shape, const Scene& scene) {
  Bounds bounds;
  if (shape.kind == ShapeKind::mesh) {
    for (const Vec3d& p : scene.meshes[shape.mesh].positions) bounds.grow(p);
  } else {
    bounds.grow(Vec3d(shape.kind == ShapeKind::quad ? 0 : -1));
    bounds.grow(shape.kind == ShapeKind::quad ? Vec3d(1, 1, 0) : Vec3d(1));
  }
  return bounds;
}

/// The shape's bounds in the world.
Bounds validatePlacement(const Scene& scene, const ShapeDesc& shape, const std::string& place) {
  double const condition = conditionNumber(Mat3d(shape.toWorld));
  if (!(condition <= maxCondition))
    fail(scene, place,
         fmt::format("the shape is flattened: its transform or edges are singular or nearly so "
                     "(condition {:.3g}, at most {:g}); make its dimensions more alike",
                     condition, maxCondition));
  if (shape.kind == ShapeKind::sphere) {
    Vec3d const axes = singularValues(Mat3d(shape.toWorld));
    if (!(axes.x <= maxSphereAspect * axes.z))
      fail(scene, place,
           fmt::format("the ellipsoid is {:.3g} times as long as thin, and beyond {:.0f} single precision loses its "
                       "surface; use a mesh, or make its radii more alike",
                       axes.x / axes.z, maxSphereAspect));
  }
  Bounds const local = localBounds(shape, scene);
  Bounds world;
  for (int i = 0; i < 8; ++i) {
    Vec3d const p = transformPoint(shape.toWorld, corner(local, i));
    if (!isPoint(p)) fail(scene, place, "the shape reaches beyond 1e14 scene units; scale the scene down");
    world.grow(p);
  }
  Vec3d const extent = world.extent();
  if (std::max({extent.x, extent.y, extent.z}) < minExtent)
    fail(scene, place, "the shape is smaller than 1e-15 scene units; scale the scene up");
  return world;
}

Bounds validateShape(const Scene& scene, const ShapeDesc& shape, const std::string& place) {
  bool const isMesh = shape.kind == ShapeKind::mesh;
  if (!within(shape.material, 0, double(scene.materials.size()) - 1)) fail(scene, place, "the shape has no material");
  if (isMesh && !within(shape.mesh, 0, double(scene.meshes.size()) - 1)) fail(scene, place, "the shape has no mesh");
  if (isMesh && shape.emission)
    fail(scene, place + "/emission", "a mesh cannot emit light; give the emission to a sphere, box or quad");
  if (shape.emission)
    for (int c = 0; c < 3; ++c)
      if (!within(shape.emission->radiance[c], 0, maxRadiance))
        fail(scene, place + "/emission/radiance", "expected finite values in [0, 1e15] W/(sr m^2)");
  return validatePlacement(scene, shape, place);
}

}  // namespace

void validateScene(const Scene& scene) {
  validateCamera(scene);
  validateFilm(scene);
  for (const Mesh& mesh : scene.meshes) validateMesh(mesh);
  if (scene.shapes.empty()) fail(scene, "/shapes", "the scene is empty; expected at least one shape");
  Bounds all;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    all.grow(validateShape(scene, scene.shapes[i], fmt::format("/shapes/{}", i)));
  Vec3d const extent = all.extent();
  double const size = std::max({extent.x, extent.y, extent.z});
  if (!within(size, minSceneSize, maxSceneSize))
    fail(scene, "/shapes",
         fmt::format("the scene is {:.3g} units across, and single precision holds scenes of {:g} to {:g}; scale it",
                     size, minSceneSize, maxSceneSize));
}

}  // namespace ropelight
