#include "render/scene/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"

namespace ropelight {

void Bounds::grow(Vec3d p) {
  min = glm::min(min, p);
  max = glm::max(max, p);
}

void Bounds::grow(const Bounds& b) {
  min = glm::min(min, b.min);
  max = glm::max(max, b.max);
}

void Bounds::clip(const Bounds& b) {
  min = glm::max(min, b.min);
  max = glm::min(max, b.max);
}

double Bounds::area() const {
  if (empty()) return 0;
  Vec3d const e = extent();
  return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

bool Bounds::overlaps(const Bounds& b) const {
  for (int a = 0; a < 3; ++a)
    if (min[a] > b.max[a] || max[a] < b.min[a]) return false;
  return true;
}

namespace {

Vec3d apply(const Mat4d& m, Vec3d p) { return Vec3d(m * glm::dvec4(p, 1.0)); }

double area(const FlatQuad& q) { return glm::length(glm::cross(q.corner[1] - q.corner[0], q.corner[3] - q.corner[0])); }

double area(const FlatTriangle& t) { return 0.5 * glm::length(glm::cross(t.b - t.a, t.c - t.a)); }

/// Shapes of one kind at a time, so that primitive numbers come out grouped.
class Flattener {
 public:
  explicit Flattener(const Scene& scene) : scene_(scene) {}

  FlatScene run() {
    for (const NamedMaterial& m : scene_.materials) out_.materials.push_back(m.desc);
    for (const ShapeDesc& s : scene_.shapes) {
      if (s.kind == ShapeKind::quad) addQuad(s);
      if (s.kind == ShapeKind::box) addBox(s);
    }
    for (const ShapeDesc& s : scene_.shapes)
      if (s.kind == ShapeKind::sphere) addSphere(s);
    for (const ShapeDesc& s : scene_.shapes)
      if (s.kind == ShapeKind::mesh) addMesh(s);
    finish();
    return std::move(out_);
  }

 private:
  bool diffuse(int material) const {
    return std::holds_alternative<DiffuseParams>(out_.materials[std::size_t(material)]);
  }

  void add(const ShapeDesc& shape, double area) {
    out_.material.push_back(std::uint32_t(shape.material));
    if (diffuse(shape.material)) out_.diffuseArea += area;
    if (shape.kind == ShapeKind::mesh) return;
    bool const emits = shape.emission && !isBlack(shape.emission->radiance);
    out_.light.push_back(emits ? std::int32_t(out_.lights.size()) : -1);
    if (!emits) return;
    FlatLight light;
    light.primitive = std::uint32_t(out_.material.size() - 1);
    light.radiance = shape.emission->radiance;
    light.side = shape.emission->side;
    light.area = area;
    light.power = M_PI * double(mean(light.radiance)) * area * (light.side == Side::both ? 2 : 1);
    out_.lights.push_back(light);
  }

  void addFace(const ShapeDesc& shape, Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
    FlatQuad const quad{{a, b, c, d}};
    out_.quads.push_back(quad);
    add(shape, area(quad));
  }

  /// A mirroring transform turns the winding round; the normal follows the inverse transpose.
  void addQuad(const ShapeDesc& s) {
    Vec3d const a = apply(s.toWorld, {0, 0, 0}), b = apply(s.toWorld, {1, 0, 0});
    Vec3d const c = apply(s.toWorld, {1, 1, 0}), d = apply(s.toWorld, {0, 1, 0});
    if (glm::determinant(Mat3d(s.toWorld)) < 0)
      addFace(s, a, d, c, b);
    else
      addFace(s, a, b, c, d);
  }

  void addBox(const ShapeDesc& s) {
    Vec3d v[8];
    for (int i = 0; i < 8; ++i) v[i] = apply(s.toWorld, {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    static constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    bool const mirrored = glm::determinant(Mat3d(s.toWorld)) < 0;
    for (const auto& f : faces) addFace(s, v[f[0]], v[f[mirrored ? 3 : 1]], v[f[2]], v[f[mirrored ? 1 : 3]]);
  }

  void addSphere(const ShapeDesc& s) {
    FlatSphere sphere{Mat3d(s.toWorld), Vec3d(s.toWorld[3])};
    if (glm::determinant(sphere.toWorld) < 0) sphere.toWorld[0] = -sphere.toWorld[0];  // the same surface, outside out
    out_.spheres.push_back(sphere);
    add(s, ellipsoidArea(sphere.toWorld));
  }

  void addMesh(const ShapeDesc& s) {
    const Mesh& mesh = scene_.meshes[std::size_t(s.mesh)];
    bool const mirrored = glm::determinant(Mat3d(s.toWorld)) < 0;
    for (glm::uvec3 t : mesh.triangles) {
      if (mirrored) std::swap(t.y, t.z);
      FlatTriangle const triangle{apply(s.toWorld, mesh.positions[t.x]), apply(s.toWorld, mesh.positions[t.y]),
                                  apply(s.toWorld, mesh.positions[t.z])};
      out_.triangles.push_back(triangle);
      add(s, area(triangle));
    }
  }

  void finish() {
    if (out_.material.size() >= (1u << 30))
      throw Error(fmt::format("{}: {} primitives; at most 2^30 fit", scene_.file, out_.material.size()));
    for (std::uint32_t i = 0; i < out_.primitiveCount(); ++i) out_.bounds.grow(out_.primitiveBounds(i));
    out_.reach = reachOf(out_.bounds, scene_.camera.position);
    if (!(out_.reach < 1e15))
      throw Error(fmt::format("{}: the scene spans {:g} units; float arithmetic needs less than 1e15: scale it down",
                              scene_.file, out_.reach));
  }

  const Scene& scene_;
  FlatScene out_;
};

/// Distance range of a box from the origin in a sphere's object space, from the images of its corners and its center.
bool boxMeetsUnitSphere(const FlatSphere& sphere, const Bounds& box) {
  Mat3d const toObject = glm::inverse(sphere.toWorld);
  Vec3d const center = toObject * (0.5 * (box.min + box.max) - sphere.center);
  Vec3d const half = 0.5 * box.extent();
  double reach = 0, farthest = 0;
  for (int i = 0; i < 8; ++i) {
    Vec3d const h = toObject * Vec3d(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z);
    reach = std::max(reach, glm::length(h));
    farthest = std::max(farthest, glm::length(center + h));
  }
  double const d = glm::length(center);
  return farthest >= 1 - 1e-9 && d - reach <= 1 + 1e-9;
}

}  // namespace

std::uint32_t FlatScene::primitiveCount() const { return std::uint32_t(material.size()); }

Bounds FlatScene::primitiveBounds(std::uint32_t i) const {
  Bounds b;
  if (i < quads.size()) {
    for (Vec3d p : quads[i].corner) b.grow(p);
  } else if (i < quads.size() + spheres.size()) {
    const FlatSphere& s = spheres[i - quads.size()];
    for (int a = 0; a < 3; ++a) {
      double const h = std::hypot(s.toWorld[0][a], s.toWorld[1][a], s.toWorld[2][a]);
      b.min[a] = s.center[a] - h;
      b.max[a] = s.center[a] + h;
    }
  } else {
    const FlatTriangle& t = triangles[i - quads.size() - spheres.size()];
    for (Vec3d p : {t.a, t.b, t.c}) b.grow(p);
  }
  return b;
}

bool FlatScene::overlapsSurface(std::uint32_t i, const Bounds& box) const {
  bool const sphere = i >= quads.size() && i < quads.size() + spheres.size();
  return !sphere || boxMeetsUnitSphere(spheres[i - quads.size()], box);
}

double reachOf(const Bounds& bounds, Vec3d position) {
  Bounds far = bounds;
  far.grow(position);
  far.grow(Vec3d(0.0));
  Vec3d const e = far.extent();
  return std::max({e.x, e.y, e.z});
}

FlatScene flatten(const Scene& scene) { return Flattener(scene).run(); }

Vec3d singularValues(const Mat3d& m) {
  Mat3d a = m;  // pairs of columns are turned until all are orthogonal (one-sided Jacobi, Hestenes 1958)
  for (int sweep = 0; sweep < 32; ++sweep) {
    for (auto [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      double const product = glm::dot(a[p], a[q]);
      if (product == 0) continue;
      double const zeta = (glm::dot(a[q], a[q]) - glm::dot(a[p], a[p])) / (2 * product);
      double const t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(zeta, 1.0));
      double const c = 1 / std::hypot(t, 1.0), s = c * t;
      Vec3d const before = a[p];
      a[p] = c * before - s * a[q];
      a[q] = s * before + c * a[q];
    }
  }
  double v[3] = {glm::length(a[0]), glm::length(a[1]), glm::length(a[2])};
  std::sort(v, v + 3, std::greater<>());
  return Vec3d(v[0], v[1], v[2]);
}

double ellipsoidArea(const Mat3d& toWorld) {
  Vec3d const s = singularValues(toWorld);
  double const scale = s.x * s.x;  // R_G is homogeneous: work with ratios so that nothing overflows
  double const b = s.y / s.x, c = s.z / s.x;
  double x = b * b * c * c, y = c * c, z = b * b;
  // R_G from R_F and R_D: 2R_G = z R_F − (x−z)(y−z) R_D/3 + sqrt(xy/z), z the largest argument here.
  double const x0 = x, y0 = y, z0 = z;
  double sum = 0, power = 1;
  for (int i = 0; i < 60; ++i) {
    double const rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    double const lambda = rx * ry + ry * rz + rz * rx;
    sum += power / (rz * (z + lambda));
    power /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
  }
  double const rf = 1 / std::sqrt((x + y + z) / 3);
  double const rd = 3 * sum + power / std::pow((x + y + z) / 3, 1.5);
  double const rg = 0.5 * (z0 * rf - (x0 - z0) * (y0 - z0) * rd / 3 + std::sqrt(x0 * y0 / z0));
  return 4 * M_PI * scale * rg;
}

FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera) {
  FeatureBits bits = 0;
  if (!flat.quads.empty()) bits |= feature::quads;
  if (!flat.spheres.empty()) bits |= feature::spheres;
  if (!flat.triangles.empty()) bits |= feature::triangles;
  for (std::uint32_t m : flat.material)
    bits |= std::visit([](const auto& params) { return params.bit; }, flat.materials[m]);
  if (camera.apertureRadius > 0) bits |= feature::lens;
  if (!flat.lights.empty()) bits |= feature::lights;
  return bits;
}

}  // namespace ropelight
