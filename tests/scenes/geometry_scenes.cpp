#include "tests/scenes/geometry_scenes.h"

namespace ropelight {

std::vector<FlatTriangle> bumpyBall(int segments, int rows) {
  auto const vertex = [&](int j, int i) {
    double const theta = M_PI * i / rows, phi = 2 * M_PI * (j % segments) / segments;
    double const s = i == 0 || i == rows ? 0 : std::sin(theta);
    double const r = 1 + 0.15 * std::sin(7 * phi) * std::sin(5 * theta) * s * s;
    return Vec3d(r * s * std::cos(phi), r * std::cos(theta), r * s * std::sin(phi));
  };
  std::vector<FlatTriangle> triangles;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < segments; ++j) {
      if (i > 0) triangles.push_back({vertex(j, i), vertex(j + 1, i), vertex(j, i + 1)});
      if (i < rows - 1) triangles.push_back({vertex(j + 1, i), vertex(j + 1, i + 1), vertex(j, i + 1)});
    }
  return triangles;
}

std::vector<FlatTriangle> randomTriangles(TestRandom& random, int count, double size) {
  std::vector<FlatTriangle> triangles;
  for (int i = 0; i < count; ++i) {
    Vec3d const p = random.inBox(1);
    triangles.push_back({p, p + random.inBox(size), p + random.inBox(size)});
  }
  return triangles;
}

Mat4d randomPlace(TestRandom& random) {
  return translation(random.inBox(1)) * rotation(random.direction(), random.between(0, 360));
}

FlatScene mixedShapes() {
  TestRandom random(31);
  SceneBuilder b;
  for (int i = 0; i < 12; ++i) {
    double const s = random.between(0.05, 0.4);
    b.add(ShapeKind::box, randomPlace(random) * scaling({s, s / 2, s / 3}));
    b.add(ShapeKind::sphere, randomPlace(random) * scaling({s, s, s}));
    b.add(ShapeKind::sphere, randomPlace(random) * scaling({s, 0.1 * s, 0.5 * s}));
    b.add(ShapeKind::quad, randomPlace(random) * scaling({3 * s, s, 1}));
    b.add(ShapeKind::box, translation(random.inBox(1)) * scaling({s / 2, s / 4, s / 8}));  // along the axes
  }
  return flatten(b.scene);
}

FlatScene coincidentShapes() {
  TestRandom random(32);
  SceneBuilder b;
  std::vector<FlatTriangle> triangles = randomTriangles(random, 8, 1);
  for (int i = 0; i < 40; ++i) triangles.push_back(triangles[std::size_t(i % 8)]);
  for (int i = 0; i < 10; ++i) triangles.push_back({{-1, 0, -1}, {1, 0, -1}, {0, 0, 0.1 * i}});
  b.mesh(triangles);
  for (int i = 0; i < 4; ++i) b.add(ShapeKind::sphere, scaling({0.5, 0.5, 0.5}));
  for (int i = 0; i < 4; ++i) b.add(ShapeKind::box, scaling({0.5, 1, 0.5}));
  for (int i = 0; i < 4; ++i) b.add(ShapeKind::quad, translation({0.1 * i, 0, 0}));
  return flatten(b.scene);
}

FlatScene degenerateTriangles() {
  TestRandom random(33);
  std::vector<FlatTriangle> triangles = randomTriangles(random, 60, 0.5);
  for (int i = 0; i < 60; ++i) {
    Vec3d const p = random.inBox(1), e = random.inBox(0.5);
    triangles.push_back({p, p, p});
    triangles.push_back({p, p + e, p});
    triangles.push_back({p, p + e, p + 2.0 * e});
    triangles.push_back({p, p + e, p + e * 1.0000001});
  }
  return flatten(SceneBuilder().mesh(triangles).scene);
}

FlatScene flatShapes() {
  TestRandom random(34);
  std::vector<FlatTriangle> triangles = randomTriangles(random, 100, 0.5);
  for (FlatTriangle& t : triangles) t.a.y = t.b.y = t.c.y = 0.25;
  SceneBuilder b;
  b.mesh(triangles);
  for (int i = 0; i < 10; ++i)
    b.add(ShapeKind::quad, translation({random.between(-1, 1), 0.25, random.between(-1, 1)}) * rotation({1, 0, 0}, 90));
  return flatten(b.scene);
}

FlatScene needles(int count) {
  TestRandom random(37);
  std::vector<FlatTriangle> triangles;
  for (int i = 0; i < count; ++i) {
    Vec3d const p = random.inBox(1), q = random.inBox(1);
    triangles.push_back({p, q, q + random.inBox(1e-5)});
  }
  return flatten(SceneBuilder().mesh(triangles).scene);
}

FlatScene coincidentTriangles(int count) {
  FlatTriangle const triangle{{0, 0, 0}, {1, 0.25, 0.5}, {0.125, 1, 0.75}};
  return flatten(SceneBuilder().mesh(std::vector<FlatTriangle>(std::size_t(count), triangle)).scene);
}

FlatScene coplanarWalls() {
  std::vector<FlatTriangle> triangles;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      double const x = 0.1 * i, y = 0.1 * j;
      triangles.push_back({{x, y, 0}, {x + 0.1, y, 0}, {x, y + 0.1, 0}});
      triangles.push_back({{x, 0.5, y}, {x + 0.2, 0.5, y}, {x, 0.5, y + 0.2}});
      triangles.push_back({{0.3, x, y}, {0.3, x + 0.1, y}, {0.3, x, y}});
    }
  SceneBuilder b;
  b.mesh(triangles);
  for (double s : {0.1, 0.3, 0.3, 0.5}) b.add(ShapeKind::box, scaling({s, s, s}));
  return flatten(b.scene);
}

FlatScene onePoint(int count, Vec3d p) {
  return flatten(SceneBuilder().mesh(std::vector<FlatTriangle>(std::size_t(count), {p, p, p})).scene);
}

FlatScene insideSphere() {
  TestRandom random(35);
  SceneBuilder b;
  b.mesh(randomTriangles(random, 300, 0.1)).add(ShapeKind::sphere, scaling({4, 4, 4})).cameraAt({0, 0, 3});
  return flatten(b.scene);
}

std::vector<GeometryScene> geometryScenes() {
  TestRandom random(36);
  SceneBuilder triangles, ball, far, quad, sphere, triangle;
  triangles.mesh(randomTriangles(random, 500, 0.3));
  ball.mesh(bumpyBall(50, 51));
  far.mesh(randomTriangles(random, 100, 0.3))
      .add(ShapeKind::sphere, scaling({0.3, 0.1, 0.3}))
      .cameraAt({900, 500, 700});
  quad.add(ShapeKind::quad, Mat4d(1.0));
  sphere.add(ShapeKind::sphere, translation({0.2, 0, 0}) * scaling({1, 0.5, 0.25}));
  triangle.mesh({{{0, 0, 0}, {1, 0, 0.25}, {0, 1, 0.5}}});
  return {{"random triangles", flatten(triangles.scene)},
          {"bumpy ball", flatten(ball.scene)},
          {"mixed shapes", mixedShapes()},
          {"coincident shapes", coincidentShapes()},
          {"degenerate triangles", degenerateTriangles()},
          {"flat shapes", flatShapes()},
          {"needles", needles(200)},
          {"coincident triangles", coincidentTriangles(300)},
          {"coplanar walls", coplanarWalls()},
          {"one point", onePoint(50, {1, 2, 3})},
          {"the origin", onePoint(50, {0, 0, 0})},
          {"inside a sphere", insideSphere()},
          {"seen from afar", flatten(far.scene)},
          {"nothing", flatten(SceneBuilder().scene)},
          {"one quad", flatten(quad.scene)},
          {"one ellipsoid", flatten(sphere.scene)},
          {"one triangle", flatten(triangle.scene)}};
}

std::vector<TreeConfig> treeConfigs() {
  auto const make = [](KdSplit split, bool clip, int bins, int leafSize, int maxDepth) {
    KdConfig c;
    c.split = split;
    c.clip = clip;
    c.bins = bins;
    c.leafSize = leafSize;
    c.maxDepth = maxDepth;
    return c;
  };
  constexpr KdSplit sah = KdSplit::sah, sweep = KdSplit::sweep, midpoint = KdSplit::midpoint;
  return {{"SAH", KdConfig{}},
          {"SAH, not clipped", make(sah, false, 32, 4, 0)},
          {"SAH, 2 bins, leaves of 1, deep", make(sah, true, 2, 1, 40)},
          {"SAH, 128 bins, leaves of 16, not clipped", make(sah, false, 128, 16, 0)},
          {"SAH, one split", make(sah, true, 32, 1, 1)},
          {"sweep", make(sweep, true, 32, 4, 0)},
          {"sweep, leaves of 1, deep", make(sweep, true, 32, 1, 40)},
          {"sweep, leaves of 1, not clipped", make(sweep, false, 32, 1, 0)},
          {"midpoint", make(midpoint, true, 32, 4, 0)},
          {"midpoint, not clipped", make(midpoint, false, 32, 4, 0)},
          {"midpoint, leaves of 1, deep", make(midpoint, true, 32, 1, 40)},
          {"one leaf", make(sah, true, 32, 1 << 20, 0)}};
}

Vec3d surfacePoint(const FlatScene& flat, std::uint32_t primitive, TestRandom& random) {
  double u = random.unit(), v = random.unit();
  std::size_t k = primitive;
  if (k < flat.quads.size()) {
    const FlatQuad& q = flat.quads[k];
    return q.corner[0] + u * (q.corner[1] - q.corner[0]) + v * (q.corner[3] - q.corner[0]);
  }
  k -= flat.quads.size();
  if (k < flat.spheres.size()) return flat.spheres[k].center + flat.spheres[k].toWorld * random.direction();
  const FlatTriangle& t = flat.triangles[k - flat.spheres.size()];
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

}  // namespace ropelight
