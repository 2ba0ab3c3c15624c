#include "app/viewer/camera/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/scene/transform.h"

namespace ropelight::view {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A ray in a shape's own space: its parameter is that of the world's ray.
struct LocalRay {
  Vec3d origin, direction;
};

double firstPositive(double near, double far) { return near > 0 ? near : far > 0 ? far : never; }

double hitSphere(const LocalRay& ray) {
  double const a = glm::dot(ray.direction, ray.direction);
  double const middle = -glm::dot(ray.origin, ray.direction) / a;
  Vec3d const nearest = ray.origin + ray.direction * middle;
  double const inside = 1 - glm::dot(nearest, nearest);
  if (!(inside >= 0)) return never;
  double const half = std::sqrt(inside / a);
  return firstPositive(middle - half, middle + half);
}

double hitBox(const LocalRay& ray) {
  double near = -never, far = never;
  for (int a = 0; a < 3; ++a) {
    double const o = ray.origin[a], d = ray.direction[a];
    if (d == 0 && !(std::abs(o) <= 1)) return never;
    if (d == 0) continue;
    double const first = (-1 - o) / d, second = (1 - o) / d;
    near = std::max(near, std::min(first, second));
    far = std::min(far, std::max(first, second));
  }
  return near <= far ? firstPositive(near, far) : never;
}

double hitQuad(const LocalRay& ray) {
  double const t = -ray.origin.z / ray.direction.z;
  Vec3d const p = ray.origin + ray.direction * t;
  return t > 0 && p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1 ? t : never;
}

/// Triangles seen along the ray: two axes across it and one along, in which edges that two triangles share get values
/// of opposite sign to the last bit, so that no ray slips through between them.
class RayAxes {
 public:
  explicit RayAxes(const LocalRay& ray) : origin_(ray.origin) {
    Vec3d const d = ray.direction, m = glm::abs(d);
    Vec3d const least =
        m.x < m.y ? (m.x < m.z ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1)) : (m.y < m.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1));
    along_ = d / glm::dot(d, d);
    first_ = glm::normalize(glm::cross(d, least));
    second_ = glm::normalize(glm::cross(d, first_));
  }

  double hit(Vec3d a, Vec3d b, Vec3d c) const {
    Vec3d const p = seen(a), q = seen(b), r = seen(c);
    double const u = edge(q, r), v = edge(r, p), w = edge(p, q);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return never;
    double const sum = u + v + w;
    if (sum == 0) return never;
    double const t = (u * p.z + v * q.z + w * r.z) / sum;
    return t > 0 ? t : never;
  }

 private:
  Vec3d seen(Vec3d p) const {
    Vec3d const d = p - origin_;
    return Vec3d(glm::dot(d, first_), glm::dot(d, second_), glm::dot(d, along_));
  }
  static double edge(Vec3d p, Vec3d q) { return p.x * q.y - p.y * q.x; }

  Vec3d origin_, first_, second_, along_;
};

double hitMesh(const LocalRay& ray, const Mesh& mesh) {
  RayAxes const axes(ray);
  double nearest = never;
  for (const glm::uvec3& t : mesh.triangles)
    nearest = std::min(nearest, axes.hit(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
  return nearest;
}

double hitShape(const Scene& scene, const ShapeDesc& shape, Vec3d origin, Vec3d direction) {
  Mat3d const toLocal = glm::inverse(Mat3d(shape.toWorld));
  LocalRay const ray{toLocal * (origin - Vec3d(shape.toWorld[3])), toLocal * direction};
  switch (shape.kind) {
    case ShapeKind::sphere:
      return hitSphere(ray);
    case ShapeKind::box:
      return hitBox(ray);
    case ShapeKind::quad:
      return hitQuad(ray);
    case ShapeKind::mesh:
      return hitMesh(ray, scene.meshes[std::size_t(shape.mesh)]);
  }
  return never;
}

/// Each row of the linear part is how far the sphere reaches along that axis.
Bounds ellipsoidBounds(const Mat4d& m) {
  Vec3d const center(m[3]);
  Vec3d reach;
  for (int a = 0; a < 3; ++a) reach[a] = std::hypot(m[0][a], m[1][a], m[2][a]);
  return {center - reach, center + reach};
}

}  // namespace

std::optional<Picked> pick(const Scene& scene, Vec3d origin, Vec3d direction) {
  Picked best;
  best.distance = never;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    double const t = hitShape(scene, scene.shapes[i], origin, direction);
    if (!(t < best.distance)) continue;
    best.shape = int(i);
    best.distance = t;
  }
  if (!(best.distance < never)) return std::nullopt;
  best.point = origin + direction * best.distance;
  return best;
}

Bounds shapeBounds(const Scene& scene, int index) {
  Bounds bounds;
  if (index < 0 || std::size_t(index) >= scene.shapes.size()) return bounds;
  const ShapeDesc& shape = scene.shapes[std::size_t(index)];
  auto const grow = [&](Vec3d local) { bounds.grow(transformPoint(shape.toWorld, local)); };
  switch (shape.kind) {
    case ShapeKind::sphere:
      return ellipsoidBounds(shape.toWorld);
    case ShapeKind::box:
      for (int i = 0; i < 8; ++i) grow(Vec3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
      break;
    case ShapeKind::quad:
      for (int i = 0; i < 4; ++i) grow(Vec3d(i & 1, i >> 1, 0));
      break;
    case ShapeKind::mesh: {
      const Mesh& mesh = scene.meshes[std::size_t(shape.mesh)];
      for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) grow(mesh.positions[t[corner]]);
      break;
    }
  }
  return bounds;
}

Bounds sceneBounds(const Scene& scene) {
  Bounds bounds;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) bounds.grow(shapeBounds(scene, int(i)));
  return bounds;
}

}  // namespace ropelight::view
