#include "render/targets/planes.h"

#include <algorithm>
#include <cmath>

namespace ropelight {
namespace {

/// Of the scene's reach: distance within which a face lies on a quad.
constexpr double nearness = 1e-6;

Vec3d normalOf(const FlatQuad& q) {
  return glm::normalize(glm::cross(q.corner[1] - q.corner[0], q.corner[3] - q.corner[0]));
}

bool inPlane(const FlatQuad& quad, Vec3d n, const FlatQuad& face, double tolerance) {
  return std::all_of(face.corner, face.corner + 4,
                     [&](Vec3d p) { return std::abs(glm::dot(n, p - quad.corner[0])) <= tolerance; });
}

bool inside(const FlatQuad& quad, Vec3d n, Vec3d p) {
  for (int k = 0; k < 4; ++k) {
    Vec3d const from = quad.corner[k];
    if (glm::dot(glm::cross(n, quad.corner[(k + 1) % 4] - from), p - from) < 0) return false;
  }
  return true;
}

}  // namespace

PlaneParts planeParts(const FlatScene& flat) {
  PlaneParts out;
  for (const FlatQuad& quad : flat.quads) {
    out.first.push_back(std::uint32_t(out.parts.size()));
    out.parts.push_back({quad});
    Vec3d const n = normalOf(quad);
    for (const FlatQuad& face : flat.hiddenFaces) {
      Vec3d const center = 0.25 * (face.corner[0] + face.corner[1] + face.corner[2] + face.corner[3]);
      if (inside(quad, n, center) && inPlane(quad, n, face, nearness * flat.reach)) out.parts.push_back({face, true});
    }
  }
  out.first.push_back(std::uint32_t(out.parts.size()));
  return out;
}

}  // namespace ropelight
