#pragma once
// Hierarchies for tests: configurations, and scenes on which builders fail.

#include <cmath>

#include "accel/bvh/build.h"
#include "render/flatten/flatten.h"
#include "tests/scenes/geometry_scenes.h"

namespace ropelight {

struct NamedConfig {
  std::string name;
  BvhConfig config;
};

inline std::vector<NamedConfig> bvhConfigs() {
  BvhConfig const sweep, bins{.sweep = false};
  BvhConfig reinserted = sweep, coarse = bins, single = sweep, full = bins;
  reinserted.reinsertion = 2;
  coarse.bins = 2;
  single.leafSize = 1;
  full.leafSize = 15;
  full.traversalCost = 1000;
  return {{"sweep", sweep},   {"bins", bins},          {"reinserted", reinserted},
          {"2 bins", coarse}, {"leaves of 1", single}, {"leaves of 15", full}};
}

inline FlatScene triangleScene(const std::vector<FlatTriangle>& triangles) {
  return flatten(SceneBuilder().mesh(triangles).scene);
}

/// Scenes on which builders fail: everything in one place, one long chain of sizes, needles, one primitive inside all.
inline std::vector<GeometryScene> hardScenes() {
  TestRandom random(51);
  std::vector<FlatTriangle> same(3000, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
      points(100, {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  std::vector<FlatTriangle> chain, needles, tiny = randomTriangles(random, 300, 0.3), flat = tiny;
  for (int i = 0; i < 600; ++i) {
    double const s = std::ldexp(1.0, -i / 10);
    chain.push_back({{0, 0, 0}, {s, 0, 0}, {0, s, s}});
    Vec3d const p = random.inBox(1e-3), d = random.direction();
    needles.push_back({p - 10.0 * d, p + 10.0 * d, p + 10.0 * d + random.inBox(1e-2)});
  }
  for (FlatTriangle& t : tiny)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) *p *= 1e-30;
  for (FlatTriangle& t : flat)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) p->x = 0;
  SceneBuilder smallest;
  smallest.mesh(tiny).cameraAt({0, 0, 1e-30});
  return {{"coincident", triangleScene(same)}, {"points", triangleScene(points)},
          {"chain", triangleScene(chain)},     {"needles", triangleScene(needles)},
          {"tiny", flatten(smallest.scene)},   {"in the plane x = 0", triangleScene(flat)}};
}

inline std::vector<GeometryScene> bvhScenes() {
  std::vector<GeometryScene> all = geometryScenes();
  for (GeometryScene& s : hardScenes()) all.push_back(std::move(s));
  std::erase_if(all, [](const GeometryScene& s) { return s.flat.primitiveCount() == 0; });
  return all;
}

}  // namespace ropelight
