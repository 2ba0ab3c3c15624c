#include "render/scene/bounds.h"

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

}  // namespace ropelight
