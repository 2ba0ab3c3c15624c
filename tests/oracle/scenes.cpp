#include "tests/oracle/scenes.h"

namespace oracle {
namespace {

struct Bounds {
  Vec low, high;
};

// The faces of an axis-aligned box with their fronts outside; inward() turns a face round.
Parallelogram left(Bounds const& b) { return {b.low, {0, 0, b.high.z - b.low.z}, {0, b.high.y - b.low.y, 0}}; }
Parallelogram right(Bounds const& b) {
  return {{b.high.x, b.low.y, b.low.z}, {0, b.high.y - b.low.y, 0}, {0, 0, b.high.z - b.low.z}};
}
Parallelogram lowY(Bounds const& b) { return {b.low, {b.high.x - b.low.x, 0, 0}, {0, 0, b.high.z - b.low.z}}; }
Parallelogram highY(Bounds const& b) {
  return {{b.low.x, b.high.y, b.low.z}, {0, 0, b.high.z - b.low.z}, {b.high.x - b.low.x, 0, 0}};
}
Parallelogram lowZ(Bounds const& b) { return {b.low, {0, b.high.y - b.low.y, 0}, {b.high.x - b.low.x, 0, 0}}; }
Parallelogram highZ(Bounds const& b) {
  return {{b.low.x, b.low.y, b.high.z}, {b.high.x - b.low.x, 0, 0}, {0, b.high.y - b.low.y, 0}};
}
Parallelogram inward(Parallelogram const& p) { return {p.corner, p.edge2, p.edge1}; }

constexpr Rgb grey(double value) { return {value, value, value}; }

}  // namespace

Scene diffuseBox(int width, int height) {
  Bounds const room{{-1, -1, -1}, {1, 1, 1}};
  Bounds const block{{-0.65, -1, -0.6}, {-0.1, 0.2, -0.05}};
  Diffuse const white{grey(0.75)};
  Scene scene;
  scene.camera = {{0, 0, 3.8}, {0, 0, 0}, {0, 1, 0}, 39, width, height};
  scene.shapes = {{inward(left(room)), Diffuse{{0.7, 0.15, 0.1}}},
                  {inward(right(room)), Diffuse{{0.15, 0.6, 0.2}}},
                  {inward(lowY(room)), white},
                  {inward(highY(room)), white},
                  {inward(lowZ(room)), white},
                  {left(block), white},
                  {right(block), white},
                  {highY(block), white},
                  {lowZ(block), white},
                  {highZ(block), white},
                  {Sphere{{0.45, -0.65, 0.2}, 0.35}, Diffuse{{0.3, 0.4, 0.8}}},
                  {lowY({{-0.3, 0.98, -0.3}, {0.3, 0.98, 0.3}}), Diffuse{}, {{14, 12, 10}}}};
  return scene;
}

Scene boxSpheresDiffuse(int width, int height) {
  Bounds const room{{-1.27029, -1.25549, -1.28002}, {1.28975, 1.30455, 1.28002}};
  Bounds const lamp{{-0.25, -0.25, 1.26002}, {0.25, 0.25, 1.28002}};
  Vec const position{-0.0439815, -4.12529, 0.222539};
  Vec const forward{0.00688625, 0.998505, -0.0542161};
  Vec const target{position.x + forward.x, position.y + forward.y, position.z + forward.z};
  Diffuse const white{grey(0.803922)};
  Scene scene;
  scene.camera = {position, target, {0.000373896, 0.0542148, 0.998529}, 45, width, height};
  scene.shapes = {{inward(left(room)), Diffuse{{0.156863, 0.803922, 0.172549}}},
                  {inward(right(room)), Diffuse{{0.803922, 0.152941, 0.152941}}},
                  {inward(highY(room)), white},
                  {inward(lowZ(room)), white},
                  {inward(highZ(room)), white},
                  {left(lamp), white},
                  {right(lamp), white},
                  {lowY(lamp), white},
                  {highY(lamp), white},
                  {lowZ(lamp), Diffuse{}, {grey(25.033299)}},
                  {Sphere{{-0.53885, 0.02453, -0.78002}, 0.5}, Mirror{}},
                  {Sphere{{0.55831, 0.02453, -0.78002}, 0.5}, Dielectric{1.6}}};
  return scene;
}

Scene pool(int width, int height) {
  Bounds const room{{-1, 0, -1}, {1, 2, 1}};
  Diffuse const wall{grey(0.6)};
  Scene scene;
  scene.camera = {{0, 1.7, 0.9}, {0, 0.3, -0.2}, {0, 1, 0}, 60, width, height};
  scene.shapes = {{inward(left(room)), Diffuse{{0.6, 0.3, 0.2}}},
                  {inward(right(room)), Diffuse{{0.2, 0.3, 0.6}}},
                  {inward(lowY(room)), Diffuse{{0.5, 0.7, 0.6}}},
                  {inward(highY(room)), wall},
                  {inward(lowZ(room)), wall},
                  {inward(highZ(room)), wall},
                  {highY({{-1, 0, -1}, {1, 0.6, 1}}), Dielectric{1.33}},
                  {lowY({{-0.5, 1.98, -0.5}, {0.5, 1.98, 0.5}}), Diffuse{}, {{5, 5, 5}}}};
  return scene;
}

Scene touchingRoom(int width, int height, double gap) {
  Bounds const room{{-1, 0, -1}, {1, 2, 1}};
  Bounds const block{{-0.5, gap, -0.6}, {0.3, 0.7, 0.1}};
  double const under = 2 - gap;
  Diffuse const wall{grey(0.6)};
  Scene scene;
  scene.camera = {{0.1, 1.3, 0.95}, {-0.1, 0.2, -0.2}, {0, 1, 0}, 60, width, height};
  scene.shapes = {{inward(left(room)), Diffuse{{0.6, 0.3, 0.2}}},
                  {inward(right(room)), Diffuse{{0.2, 0.3, 0.6}}},
                  {inward(lowY(room)), Diffuse{{0.5, 0.7, 0.3}}},
                  {inward(highY(room)), wall},
                  {inward(lowZ(room)), wall},
                  {inward(highZ(room)), wall},
                  {lowY({{-0.8, under, -0.8}, {0.8, under, 0.8}}), Diffuse{}, {{5, 5, 5}}}};
  for (auto* face : {left, right, lowY, highY, lowZ, highZ}) scene.shapes.push_back({face(block), Dielectric{1.5}});
  return scene;
}

}  // namespace oracle
