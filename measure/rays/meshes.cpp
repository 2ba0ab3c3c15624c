#include "measure/rays/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "render/core/error.h"
#include "render/import/obj/obj.h"

namespace ropelight {
namespace {

/// As the text of a mesh file has it.
double sixDigits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::strtod(text, nullptr);
}

Vec3d bumpyPoint(double theta, double phi, bool pole) {
  double const s = pole ? 0 : std::sin(theta), s2 = s * s;
  double const r = 1 + 0.08 * std::sin(17 * phi) * std::sin(13 * theta) * s2 +
                   0.02 * std::sin(71 * phi + 3) * std::sin(67 * theta + 1) * s2;
  return {sixDigits(r * s * std::cos(phi)), sixDigits(r * std::cos(theta)), sixDigits(r * s * std::sin(phi))};
}

/// A sphere's grid of vertices; the last segment joins the first.
class Rings {
 public:
  Rings(int segments, int rows) : segments_(segments) {
    points_.reserve(std::size_t(segments) * std::size_t(rows));
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < segments; ++j)
        points_.push_back(bumpyPoint(M_PI * i / (rows - 1), 2 * M_PI * j / segments, i == 0 || i == rows - 1));
  }

  FlatTriangle upper(int i, int j) const { return {at(i, j), at(i, j + 1), at(i + 1, j)}; }
  FlatTriangle lower(int i, int j) const { return {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}; }

 private:
  const Vec3d& at(int i, int j) const {
    return points_[std::size_t(i) * std::size_t(segments_) + std::size_t(j % segments_)];
  }

  int segments_;
  std::vector<Vec3d> points_;
};

template <class Function>
void forEachVertex(std::vector<FlatTriangle>& triangles, Function function) {
  for (FlatTriangle& t : triangles)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) function(*p);
}

}  // namespace

std::uint32_t bumpyTriangles(int segments, int rows) { return 2 * std::uint32_t(segments) * (std::uint32_t(rows) - 2); }

std::vector<FlatTriangle> bumpySphere(int segments, int rows) {
  Rings const rings(segments, rows);
  std::vector<FlatTriangle> triangles;
  triangles.reserve(bumpyTriangles(segments, rows));
  auto const add = [&](int firstRow, int lastRow, FlatTriangle (Rings::*triangle)(int, int) const) {
    for (int i = firstRow; i <= lastRow; ++i)
      for (int j = 0; j < segments; ++j) triangles.push_back((rings.*triangle)(i, j));
  };
  add(1, rows - 3, &Rings::upper);
  add(1, rows - 3, &Rings::lower);
  add(0, 0, &Rings::lower);
  add(rows - 2, rows - 2, &Rings::upper);
  return triangles;
}

std::vector<FlatTriangle> bumpySphereOf(std::uint32_t triangles) {
  int const half = std::max(5, int(triangles / 2)), least = std::max(1, int(std::sqrt(half / 4.0)));
  int best = least, error = half;
  for (int bands = least; bands * bands <= half; ++bands) {  // one to four times as many segments as bands
    int const e = std::abs(half - bands * int(std::lround(double(half) / bands)));
    if (e < error) best = bands, error = e;
  }
  return bumpySphere(int(std::lround(double(half) / best)), best + 2);
}

std::vector<FlatTriangle> objTriangles(const std::filesystem::path& path) {
  Mesh const mesh = loadObj(path);
  std::vector<FlatTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    triangles.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
  return triangles;
}

void normalise(std::vector<FlatTriangle>& triangles) {
  Bounds bounds;
  forEachVertex(triangles, [&](Vec3d& p) { bounds.grow(p); });
  Vec3d const centre = 0.5 * (bounds.min + bounds.max), extent = bounds.extent();
  double const half = 0.5 * std::max({extent.x, extent.y, extent.z});
  if (!(half > 0)) throw Error("the mesh has no size: all its vertices coincide; take another one");
  forEachVertex(triangles, [&](Vec3d& p) { p = Vec3d(glm::vec3((p - centre) / half)); });
}

void appendRoom(std::vector<FlatTriangle>& triangles) {
  for (int const axis : {2, 1, 0}) {
    int const u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    for (double const side : {-2.5, 2.5}) {
      auto const corner = [&](double x, double y) {
        Vec3d p;
        p[axis] = side;
        p[u] = x;
        p[v] = y;
        return p;
      };
      Vec3d const low = corner(-2.5, -2.5), high = corner(2.5, 2.5);
      bool const uFirst = (side < 0) == (axis != 1);  // the winding that faces in
      Vec3d const second = uFirst ? corner(2.5, -2.5) : corner(-2.5, 2.5);
      Vec3d const fourth = uFirst ? corner(-2.5, 2.5) : corner(2.5, -2.5);
      triangles.push_back({low, second, high});
      triangles.push_back({low, high, fourth});
    }
  }
}

FlatScene triangleScene(std::vector<FlatTriangle> triangles) {
  FlatScene scene;
  scene.triangles = std::move(triangles);
  scene.material.assign(scene.triangles.size(), 0);
  scene.materials.push_back(DiffuseParams{});
  forEachVertex(scene.triangles, [&](Vec3d& p) { scene.bounds.grow(p); });
  scene.reach = reachOf(scene.bounds, Vec3d(0.0));
  return scene;
}

}  // namespace ropelight
