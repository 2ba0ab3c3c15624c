#pragma once
// Closed rooms of radiance 1 with white, mirroring and transparent things that touch: everything in them is 1.

#include <string>
#include <vector>

#include "tests/support/rendering.h"

namespace ropelight::testing {

struct FurnaceCase {
  std::string name;
  Scene scene;
};

/// The twelve triangles of a box, outside out.
inline ShapeDesc& addMeshBox(Scene& scene, Vec3d low, Vec3d high, int material) {
  static constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  for (auto const& f : faces) {
    mesh.triangles.push_back(glm::uvec3(f[0], f[1], f[2]));
    mesh.triangles.push_back(glm::uvec3(f[0], f[2], f[3]));
  }
  scene.meshes.push_back(mesh);
  ShapeDesc shape;
  shape.kind = ShapeKind::mesh;
  shape.name = "glass";
  shape.material = material;
  shape.mesh = int(scene.meshes.size()) - 1;
  scene.shapes.push_back(shape);
  return scene.shapes.back();
}

struct Furnace {
  Scene scene = emptyScene(1);
  int black = addMaterial(scene, DiffuseParams{Rgb(0.0f)}), glass = addMaterial(scene, DielectricParams{1.5f});
  int water = addMaterial(scene, DielectricParams{1.33f}), mirror = addMaterial(scene, MirrorParams{});

  Furnace() {
    addBox(scene, {-3, -0.5, -3}, {3, 5, 3}, black).emission = Emission{Rgb(1), Side::in};
    lookAt(scene, {1.5, 2.2, 2.9}, {0, 0.4, 0}, {0, 1, 0}, 25);
  }
  Furnace& floor() {
    addQuad(scene, {-2.5, 0, 2.5}, {5, 0, 0}, {0, 0, -5});
    return *this;
  }
  Furnace& box(Vec3d low, Vec3d high, int material) {
    addBox(scene, low, high, material).name = "glass";
    return *this;
  }
  Furnace& mesh(Vec3d low, Vec3d high, int material) {
    addMeshBox(scene, low, high, material);
    return *this;
  }
  Furnace& ball(double radius, int material) {
    addSphere(scene, {0, 0.6, 0}, radius, material);
    return *this;
  }
  Furnace& quad(double y, double half, int material, std::optional<Side> emits = {}) {
    ShapeDesc& shape = addQuad(scene, {-half, y, half}, {2 * half, 0, 0}, {0, 0, -2 * half}, material);
    if (emits) shape.emission = Emission{Rgb(1), *emits};
    return *this;
  }
  operator FurnaceCase() const { return {"", scene}; }
};

inline FurnaceCase named(const char* name, const Furnace& f) { return {name, f.scene}; }

/// Three surfaces last, which touch one another.
inline std::vector<FurnaceCase> furnaceTriples() {
  std::vector<FurnaceCase> cases;
  Furnace a, b, c, d;
  a.floor().box({-0.5, 0, -0.5}, {0, 1, 0.5}, a.glass).box({0, 0, -0.5}, {0.5, 1, 0.5}, a.water);
  b.floor().box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, b.glass).box({-0.3, 0, -0.3}, {0.5, 0.6, 0.3}, b.water);
  c.floor().mesh({-0.5, 0, -0.5}, {0.5, 1, 0.5}, c.glass).quad(0, 0.3, c.mirror);
  d.box({-0.5, 0.1, -0.5}, {0.5, 0.5, 0.5}, d.glass).mesh({-0.3, 0.5, -0.3}, {0.4, 0.9, 0.4}, d.water);
  d.quad(0.5, 0.2, d.black, Side::both);
  return {named("floor, glass, water", a), named("floor, glass, water inside it", b), named("floor, mesh, mirror", c),
          named("glass, water mesh, lamp between", d)};
}

inline std::vector<FurnaceCase> furnaceCases() {
  Furnace onFloor, floorLast, meshOnFloor, sharedFace, sharedMesh, inside, ballInBall, lampInWall, mirrorOnWhite;
  onFloor.floor().box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, onFloor.glass);
  floorLast.box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, floorLast.glass).floor();
  meshOnFloor.floor().mesh({-0.5, 0, -0.5}, {0.5, 1, 0.5}, meshOnFloor.glass);
  sharedFace.floor().box({-0.5, 0.1, -0.5}, {0, 1, 0.5}, sharedFace.glass);
  sharedFace.box({0, 0.1, -0.5}, {0.5, 1, 0.5}, sharedFace.glass);
  sharedMesh.mesh({-0.5, 0.1, -0.5}, {0, 1, 0.5}, sharedMesh.glass);
  sharedMesh.mesh({0, 0.1, -0.4}, {0.5, 0.8, 0.3}, sharedMesh.water);
  inside.floor().box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, inside.glass);
  inside.box({-0.5, 0, -0.5}, {0.3, 0.5, 0.5}, inside.water);
  ballInBall.ball(0.5, ballInBall.glass).ball(0.5, ballInBall.water);
  lampInWall.floor().quad(0, 0.5, lampInWall.black, Side::both);
  mirrorOnWhite.floor().quad(0, 0.5, mirrorOnWhite.mirror);
  return {named("glass on a floor", onFloor),
          named("floor after the glass", floorLast),
          named("mesh on a floor", meshOnFloor),
          named("two boxes with one face", sharedFace),
          named("two meshes with parts of a face", sharedMesh),
          named("water in glass at no distance", inside),
          named("ball in a ball at no distance", ballInBall),
          named("lamp in the plane of a floor", lampInWall),
          named("mirror in the plane of a floor", mirrorOnWhite)};
}

}  // namespace ropelight::testing
