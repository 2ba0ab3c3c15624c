#include "render/import/obj/obj_scene.h"

#include "render/core/error.h"
#include "render/import/obj/obj.h"
#include "render/scene/bounds.h"
#include "render/scene/transform.h"

namespace ropelight {
namespace {

/// The sphere that the scene is built around, in the mesh's units.
struct Framing {
  Vec3d center;
  double radius;
  double floor;  ///< y of the lowest vertex
};

Framing frame(const Mesh& mesh) {
  Bounds bounds;  // of the faces; other vertices may be anywhere
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) bounds.grow(mesh.positions[t[i]]);
  Vec3d const low = bounds.min, high = bounds.max;
  double const radius = glm::length(high - low) / 2;
  if (!(radius >= minExtent && radius <= maxCoordinate / 100))
    throw Error(mesh.file + ": the mesh has no usable size: its vertices all coincide or lie too far apart");
  return {(low + high) / 2.0, radius, low.y};
}

CameraDesc frameCamera(const Framing& f) {
  CameraDesc camera;
  camera.verticalFov = 36;
  camera.target = f.center;
  camera.position = f.center + glm::normalize(Vec3d(0.35, 0.4, 1)) * (f.radius * 3.4);
  return camera;
}

ShapeDesc makeShape(ShapeKind kind, const char* name, int material, const Mat4d& toWorld) {
  ShapeDesc shape;
  shape.kind = kind;
  shape.name = name;
  shape.material = material;
  shape.toWorld = toWorld;
  return shape;
}

/// A box around mesh and camera. Its floor lies a hair below the mesh, whose base may be flat.
ShapeDesc makeRoom(const Framing& f, int material) {
  double const r = f.radius, height = 6 * r;
  Vec3d const center(f.center.x, f.floor - 1e-3 * r + height / 2, f.center.z);
  return makeShape(ShapeKind::box, "room", material, translation(center) * scaling(Vec3d(5 * r, height / 2, 5 * r)));
}

/// Faces down from above, in front of the mesh and to the left, so that shadows fall away from the camera.
ShapeDesc makeLight(const Framing& f, int material) {
  double const r = f.radius, edge = 2.4 * r;
  Vec3d const center = f.center + Vec3d(-0.8, 3.5, 1.2) * r;
  Mat4d const place = quadToWorld(center - Vec3d(edge, 0, edge) / 2.0, Vec3d(edge, 0, 0), Vec3d(0, 0, edge));
  ShapeDesc light = makeShape(ShapeKind::quad, "light", material, place);
  light.emission = Emission{Rgb(8.5f, 8.2f, 7.7f), Side::out};
  return light;
}

}  // namespace

Scene loadObjScene(const std::filesystem::path& path) {
  Scene scene;
  scene.file = path.string();
  scene.name = path.stem().string();
  scene.meshes.push_back(loadObj(path));
  Framing const framing = frame(scene.meshes.front());
  scene.camera = frameCamera(framing);
  scene.materials = {
      {"grey", DiffuseParams{Rgb(0.6f)}}, {"room", DiffuseParams{Rgb(0.75f)}}, {"black", DiffuseParams{Rgb(0.0f)}}};
  ShapeDesc mesh = makeShape(ShapeKind::mesh, scene.name.c_str(), 0, Mat4d(1.0));
  mesh.mesh = 0;
  scene.shapes = {mesh, makeRoom(framing, 1), makeLight(framing, 2)};
  return scene;
}

}  // namespace ropelight
