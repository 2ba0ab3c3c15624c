#pragma once
// Scenes in which one mesh stands in many places.

#include "tests/scenes/geometry_scenes.h"

namespace ropelight {

struct Place {
  std::string name;
  Mat4d toWorld;
};

/// Of something of size 1 around the origin, to something of size s not far from it.
inline std::vector<Place> places(double s) {
  TestRandom random(61);
  Mat4d const size = scaling(Vec3d(s)), turn = rotation(random.direction(), 77), back = rotation({1, 2, 3}, 50);
  Mat4d shear(1.0);
  shear[1][0] = 0.7;
  auto const at = [&](double x, double y, double z) { return translation(Vec3d(x, y, z) * s); };
  return {{"scaled", at(-2, 0, 0) * size},
          {"turned", at(2, 0, 0) * turn * size},
          {"uneven", at(0, -2, 0) * turn * scaling({1, 0.1, 0.4}) * size},
          {"mirrored", at(0, 2, 0) * turn * scaling({-1, 1, 1}) * size},
          {"mirrored thrice", at(0, 0, 2) * scaling({-0.5, -1, -2}) * back * size},
          {"sheared", at(0, 0, -2) * shear * turn * size},
          {"turned, then flattened", at(2, 0, 2) * scaling({1, 0.03, 1}) * turn * size},
          {"uneven, then turned", at(2, 2, 0) * scaling({1, 0.3, 0.5}) * turn * size},
          {"there and back",
           at(-2, -2, 0) * back * translation({-3e3 * s, 7e2 * s, 1e3 * s}) * size * translation({3e3, -7e2, -1e3})}};
}

inline std::vector<FlatTriangle> scattered(std::uint32_t seed, int count, double size) {
  TestRandom random(seed);
  return randomTriangles(random, count, size);
}

/// A mesh at all places with other shapes around, within [−1.5, 1.5].
inline Scene placed(const std::vector<FlatTriangle>& mesh) {
  SceneBuilder b;
  b.scene.materials.push_back({"other", MirrorParams{}});
  b.mesh(scattered(62, 40, 0.3));
  b.mesh(mesh, scaling(Vec3d(0.3)));
  for (const Place& p : places(0.3)) b.place(1, p.toWorld);
  b.scene.shapes.back().material = 1;
  b.place(1, scaling(Vec3d(0.31)));  // around the first
  b.add(ShapeKind::box, translation({0.8, -0.8, 0.8}) * scaling(Vec3d(0.2)));
  b.add(ShapeKind::sphere, translation({-0.8, 0.8, 0.8}) * scaling(Vec3d(0.3)));
  return b.scene;
}

inline Scene placedBalls() { return placed(bumpyBall(16, 12)); }

}  // namespace ropelight
