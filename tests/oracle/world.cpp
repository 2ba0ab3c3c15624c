#include "tests/oracle/world.h"

#include <stdexcept>

namespace oracle {
namespace {

double area(Sphere const& s) { return 4 * std::numbers::pi * s.radius * s.radius; }
double area(Parallelogram const& p) { return length(cross(p.edge1, p.edge2)); }
double area(Triangle const& t) { return length(cross(t.b - t.a, t.c - t.a)) / 2; }

double extent(Vec v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double extent(Sphere const& s) { return extent(s.center) + s.radius; }
double extent(Parallelogram const& p) { return extent(p.corner) + extent(p.edge1) + extent(p.edge2); }
double extent(Triangle const& t) { return std::max({extent(t.a), extent(t.b), extent(t.c)}); }

void add(Shapes& to, int id, Sphere const& s) { to.balls.push_back({s.center, s.radius, id}); }
void add(Shapes& to, int id, Parallelogram const& p) { to.flats.emplace_back(p.corner, p.edge1, p.edge2, false, id); }
void add(Shapes& to, int id, Triangle const& t) { to.flats.emplace_back(t.a, t.b - t.a, t.c - t.a, true, id); }

LightPoint pointOn(Sphere const& s, int id, Random& random) {
  double const z = 1 - 2 * random.next();
  double const r = std::sqrt(1 - z * z);
  double const phi = 2 * std::numbers::pi * random.next();
  Vec const n{r * std::cos(phi), r * std::sin(phi), z};
  return {id, s.center + s.radius * n, n};
}

LightPoint pointOn(Parallelogram const& p, int id, Random& random) {
  double const u = random.next();
  double const v = random.next();
  return {id, p.corner + u * p.edge1 + v * p.edge2, normalize(cross(p.edge1, p.edge2))};
}

LightPoint pointOn(Triangle const& t, int id, Random& random) {
  double u = random.next();
  double v = random.next();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  Vec const edge1 = t.b - t.a;
  Vec const edge2 = t.c - t.a;
  return {id, t.a + u * edge1 + v * edge2, normalize(cross(edge1, edge2))};
}

double power(Shape const& shape, double area) {
  Rgb const& r = shape.emission.radiance;
  return (r[0] + r[1] + r[2]) * area * (shape.emission.side == Side::both ? 2 : 1);
}

}  // namespace

World::World(Scene const& scene) : shapes(scene.shapes), areaPdf(scene.shapes.size(), 0.0) {
  double size = extent(scene.camera.position);
  double total = 0;
  std::vector<double> areas;
  for (Shape const& shape : shapes) {
    areas.push_back(std::visit([](auto const& g) { return area(g); }, shape.geometry));
    if (!(areas.back() > 0)) throw std::invalid_argument("oracle: a shape without area");
    int const id = static_cast<int>(areas.size()) - 1;
    std::visit([&](auto const& g) { add(search, id, g), size = std::max(size, extent(g)); }, shape.geometry);
    total += power(shape, areas.back());
  }
  search.epsilon = 1e-9 * size;

  double sum = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    double const share = power(shapes[i], areas[i]);
    if (share == 0) continue;
    sum += share;
    lights.push_back({static_cast<int>(i), sum / total});
    areaPdf[i] = share / total / areas[i];
  }
}

LightPoint World::sampleLight(Random& random) const {
  double const u = random.next();
  auto light = lights.begin();
  while (light + 1 != lights.end() && u >= light->cumulative) ++light;
  auto const& geometry = shapes[static_cast<std::size_t>(light->shape)].geometry;
  return std::visit([&](auto const& g) { return pointOn(g, light->shape, random); }, geometry);
}

}  // namespace oracle
