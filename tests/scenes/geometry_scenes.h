#pragma once
// Scenes for tests of ray tracing: ordinary ones, and those on which trees and intersection tests go wrong.

#include <string>

#include "render/flatten/flatten.h"
#include "tests/scenes/host_scene.h"
#include "tests/support/test_random.h"

namespace ropelight {

struct GeometryScene {
  std::string name;
  FlatScene flat;
};

/// A closed, bumpy ball of 2·segments·(rows − 1) triangles around the origin; vertices are shared bit for bit.
std::vector<FlatTriangle> bumpyBall(int segments, int rows);
std::vector<FlatTriangle> randomTriangles(TestRandom& random, int count, double size);
Mat4d randomPlace(TestRandom& random);
/// Boxes, spheres, ellipsoids and quads through one another.
FlatScene mixedShapes();
/// The same surfaces several times over, and others in the same plane.
FlatScene coincidentShapes();
/// Points, segments and slivers among ordinary triangles.
FlatScene degenerateTriangles();
/// Everything in the plane y = 0.25.
FlatScene flatShapes();
/// Long and thin in every direction: they cross most cells of their bounds' boxes, or few, depending on who looks.
FlatScene needles(int count);
/// One slanted triangle many times over.
FlatScene coincidentTriangles(int count);
/// Walls along the axes that lie in one another and share edges, and triangles in the same planes.
FlatScene coplanarWalls();
/// All primitives in one point.
FlatScene onePoint(int count, Vec3d p);
/// A sphere as large as the room around small things, which it must not be tested with.
FlatScene insideSphere();
std::vector<GeometryScene> geometryScenes();

struct TreeConfig {
  std::string name;
  KdConfig config;
};

std::vector<TreeConfig> treeConfigs();
/// A point of the primitive's surface.
Vec3d surfacePoint(const FlatScene& flat, std::uint32_t primitive, TestRandom& random);

}  // namespace ropelight
