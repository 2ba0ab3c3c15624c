#include "measure/scenes/scene_kit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ropelight {
namespace {

ShapeDesc& add(Scene& scene, ShapeKind kind, const Mat4d& toWorld, int material) {
  ShapeDesc shape;
  shape.kind = kind;
  shape.toWorld = toWorld;
  shape.material = material;
  scene.shapes.push_back(shape);
  return scene.shapes.back();
}

Mat4d columns(Vec3d x, Vec3d y, Vec3d z, Vec3d origin) {
  return Mat4d(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(origin, 1));
}

}  // namespace

Scene emptyScene(float albedo) {
  Scene scene;
  addMaterial(scene, DiffuseParams{Rgb(albedo)});
  return scene;
}

int addMaterial(Scene& scene, const MaterialDesc& desc) {
  scene.materials.push_back({"material " + std::to_string(scene.materials.size()), desc});
  return int(scene.materials.size()) - 1;
}

ShapeDesc& addQuad(Scene& scene, Vec3d corner, Vec3d edge1, Vec3d edge2, int material) {
  return add(scene, ShapeKind::quad, columns(edge1, edge2, glm::normalize(glm::cross(edge1, edge2)), corner), material);
}

ShapeDesc& addSphere(Scene& scene, Vec3d center, double radius, int material) {
  return add(scene, ShapeKind::sphere, columns({radius, 0, 0}, {0, radius, 0}, {0, 0, radius}, center), material);
}

ShapeDesc& addBox(Scene& scene, Vec3d min, Vec3d max, int material) {
  Vec3d const h = 0.5 * (max - min);
  return add(scene, ShapeKind::box, columns({h.x, 0, 0}, {0, h.y, 0}, {0, 0, h.z}, 0.5 * (min + max)), material);
}

ShapeDesc& addMesh(Scene& scene, Mesh mesh, int material) {
  scene.meshes.push_back(std::move(mesh));
  ShapeDesc& shape = add(scene, ShapeKind::mesh, Mat4d(1.0), material);
  shape.mesh = int(scene.meshes.size()) - 1;
  return shape;
}

void lookAt(Scene& scene, Vec3d position, Vec3d target, Vec3d up, double verticalFov) {
  scene.camera.position = position;
  scene.camera.target = target;
  scene.camera.up = up;
  scene.camera.verticalFov = verticalFov;
}

Scene sphereFurnace(Rgb albedo, double radius, float emitted) {
  Scene scene = emptyScene(0);
  scene.materials[0].desc = DiffuseParams{albedo};
  addSphere(scene, Vec3d(0), radius).emission = Emission{Rgb(emitted), Side::in};
  lookAt(scene, Vec3d(0.3, 0.2, 0.1) * radius, Vec3d(-0.5, 0.1, -1) * radius, {0, 1, 0}, 60);
  return scene;
}

double discGain(double r) {
  double const within = r < 1 ? 1 - std::sqrt(1 - r * r) : 2;  // height of the cap that the cylinder cuts out
  return 2 * std::min({within, 0.2 * r, 0.9}) / (r * r);
}

Scene boxFurnace(Rgb albedo, float emitted) {
  Scene scene = emptyScene(0);
  scene.materials[0].desc = DiffuseParams{albedo};
  addBox(scene, Vec3d(-1), Vec3d(1)).emission = Emission{Rgb(emitted), Side::in};
  lookAt(scene, {0.3, 0.2, 0.6}, {0, 0, -1}, {0, 1, 0}, 50);
  return scene;
}

Scene whiteSurroundings(double halfSize) {
  Scene scene = emptyScene(0);
  addBox(scene, Vec3d(-halfSize), Vec3d(halfSize)).emission = Emission{Rgb(1), Side::in};
  return scene;
}

Scene mixedRoom() {
  Scene scene = emptyScene(0.7f);
  int const red = addMaterial(scene, DiffuseParams{Rgb(0.7f, 0.2f, 0.1f)});
  int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
  int const glass = addMaterial(scene, DielectricParams{1.5f, Rgb(1), Rgb(1)});
  int const mirror = addMaterial(scene, MirrorParams{Rgb(0.9f)});
  addBox(scene, Vec3d(-1), Vec3d(1));
  addQuad(scene, {-0.99, -1, -1}, {0, 0, 2}, {0, 2, 0}, red);
  addQuad(scene, {-0.25, 0.98, -0.25}, {0.5, 0, 0}, {0, 0, 0.5}, black).emission = Emission{Rgb(10), Side::out};
  addSphere(scene, {0.4, -0.6, 0.1}, 0.35, glass);
  addSphere(scene, {-0.4, -0.6, -0.4}, 0.35, mirror);
  ShapeDesc& mesh = addMesh(scene, sphereMesh(10), red);
  mesh.toWorld = glm::dmat4(glm::dvec4(0.2, 0, 0, 0), glm::dvec4(0, 0.2, 0, 0), glm::dvec4(0, 0, 0.2, 0),
                            glm::dvec4(-0.1, -0.75, 0.5, 1));
  lookAt(scene, {0, 0.1, 0.95}, {0, -0.2, -1}, {0, 1, 0}, 70);
  return scene;
}

Scene mirrorCell(float albedo) {
  Scene scene = emptyScene(albedo);
  int const black = addMaterial(scene, DiffuseParams{Rgb(0)});
  int const mirror = addMaterial(scene, MirrorParams{Rgb(1)});
  addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  addQuad(scene, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, black).emission = Emission{Rgb(1), Side::out};
  addQuad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, mirror);
  addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 2, 0}, mirror);
  addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {0, 2, 0}, mirror);
  addQuad(scene, {1, 0, -1}, {0, 0, 2}, {0, 2, 0}, mirror);
  lookAt(scene, {0, 0.8, 0.3}, {0, 0, 0}, {0, 1, 0}, 40);
  return scene;
}

Mesh sphereMesh(int rings) {
  Mesh mesh;
  int const around = 2 * rings;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      double const theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * j / around;
      mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  auto const at = [&](int i, int j) { return glm::uint(i * around + j % around); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      if (i > 0) mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i < rings - 1) mesh.triangles.emplace_back(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
    }
  return mesh;
}

}  // namespace ropelight
