#include "measure/rays/stress_meshes.h"

#include <random>

#include "measure/rays/meshes.h"

namespace ropelight {
namespace {

/// The same numbers everywhere, unlike the distributions of <random>.
class Random {
 public:
  double between(double low, double high) { return low + (high - low) * (double(engine_()) / 4294967296.0); }
  Vec3d inBox(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

 private:
  std::mt19937 engine_{20131212};
};

FlatTriangle around(Vec3d center, double size, Random& random) {
  return {center + random.inBox(size), center + random.inBox(size), center + random.inBox(size)};
}

/// Of every size from a millionth of the scene to the scene.
std::vector<FlatTriangle> soup(Random& random) {
  std::vector<FlatTriangle> out;
  for (int i = 0; i < 3000; ++i) out.push_back(around(random.inBox(1), std::pow(10, random.between(-6, 0)), random));
  return out;
}

std::vector<FlatTriangle> needles(Random& random) {
  std::vector<FlatTriangle> out;
  for (int i = 0; i < 3000; ++i) {
    Vec3d const a = random.inBox(1), b = random.inBox(1);
    out.push_back({a, b, b + random.inBox(std::pow(10, random.between(-7, -2)))});
  }
  return out;
}

/// Points, segments, slivers within a rounding of a line, and triangles that share all three vertices.
std::vector<FlatTriangle> degenerate(Random& random) {
  std::vector<FlatTriangle> out;
  for (int i = 0; i < 500; ++i) {
    Vec3d const p = random.inBox(1), e = random.inBox(0.5);
    FlatTriangle const whole = around(p, 0.3, random);
    out.insert(out.end(), {whole, whole, {whole.c, whole.b, whole.a}, {p, p, p}, {p, p + e, p}});
    out.insert(out.end(), {{p, p + e, p + 2.0 * e}, {p, p + e, p + e * 1.0000001}});
  }
  return out;
}

/// A wall of 2 × 50 × 50 triangles in x = 0.25, three times at the same place, and one wall across it.
std::vector<FlatTriangle> flat() {
  std::vector<FlatTriangle> out;
  auto const at = [](int y, int z) { return Vec3d(0.25, y / 25.0 - 1, z / 25.0 - 1); };
  for (int copy = 0; copy < 3; ++copy)
    for (int y = 0; y < 50; ++y)
      for (int z = 0; z < 50; ++z) {
        out.push_back({at(y, z), at(y + 1, z), at(y + 1, z + 1)});
        out.push_back({at(y, z), at(y + 1, z + 1), at(y, z + 1)});
      }
  for (int y = 0; y < 50; ++y) out.push_back({at(y, 0), at(y, 50), at(y, 25) + Vec3d(0.5, 0, 0)});
  return out;
}

/// A dense mesh the size of a grain beside a wall that is a million times as large.
std::vector<FlatTriangle> grain() {
  std::vector<FlatTriangle> out = bumpySphere(40, 41);
  for (FlatTriangle& t : out)
    for (Vec3d* v : {&t.a, &t.b, &t.c}) *v = *v * 1e-3 + Vec3d(0.5, 0.5, 0.5);
  appendRoom(out);
  for (std::size_t i = out.size() - roomTriangles; i < out.size(); ++i)
    for (Vec3d* v : {&out[i].a, &out[i].b, &out[i].c}) *v *= 400.0;
  return out;
}

/// Thin triangles that all share one vertex.
std::vector<FlatTriangle> fan(Random& random) {
  std::vector<FlatTriangle> out;
  for (int i = 0; i < 100000; ++i) {
    Vec3d const a = random.inBox(1);
    out.push_back({Vec3d(0.1, 0.2, 0.3), a, a + random.inBox(0.01)});
  }
  return out;
}

std::vector<FlatTriangle> moved(std::vector<FlatTriangle> triangles, double scale, Vec3d by) {
  for (FlatTriangle& t : triangles)
    for (Vec3d* v : {&t.a, &t.b, &t.c}) *v = Vec3d(cpu::Vec3(*v * scale + by));
  return triangles;
}

std::vector<FlatTriangle> coincident(Random& random) {
  std::vector<FlatTriangle> out(9000, around(Vec3d(0), 1, random));
  for (int i = 0; i < 500; ++i) out.push_back(around(random.inBox(1), 0.1, random));
  return out;
}

}  // namespace

std::vector<StressMesh> stressMeshes(bool large) {
  Random random;
  std::vector<FlatTriangle> ball = bumpySphere(70, 71);
  normalise(ball);
  std::vector<FlatTriangle> room = ball;
  appendRoom(room);
  std::vector<StressMesh> meshes{{"closed ball", ball, 0.5},
                                 {"ball in a room", room, 0.5},
                                 {"tiny ball", moved(ball, 1e-9, Vec3d(0)), 0.5e-9},
                                 {"huge ball", moved(ball, 1e9, Vec3d(0)), 0.5e9},
                                 {"far ball", moved(ball, 1, Vec3d(1000, -500, 700)), 0},
                                 {"soup", soup(random), 0},
                                 {"needles", needles(random), 0},
                                 {"degenerate", degenerate(random), 0},
                                 {"flat", flat(), 0},
                                 {"grain in a hall", grain(), 0},
                                 {"coincident", coincident(random), 0},
                                 {"fan", fan(random), 0}};
  if (!large) return meshes;
  std::vector<FlatTriangle> million = bumpySphere(1001, 501);
  normalise(million);
  meshes.push_back({"ball of a million", std::move(million), 0.5});
  return meshes;
}

}  // namespace ropelight
