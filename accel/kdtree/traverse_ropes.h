#pragma once
// Stackless traversal by ropes. A cell is found by comparing the ray's parameter with that of each split plane, never
// by comparing a rounded point: (s − o)/d is monotone in s even after rounding, so the cells visited follow one another
// without gaps or loops, whatever the ray.

#include "accel/kdtree/kd_tree.h"
#include "render/core/ray.h"

namespace ropelight::RL_TARGET {

/// Plane parameters of one ray. Along a zero component they are ±∞, or NaN in the plane itself, which counts as passed.
struct RayPlanes {
  Vec3 origin, inverse;
  bool positive[3];

  RL_HD explicit RayPlanes(const Ray& ray) : origin(ray.origin), inverse(Real(1) / ray.direction) {
    positive[0] = copysign(Real(1), inverse.x) > 0;
    positive[1] = copysign(Real(1), inverse.y) > 0;
    positive[2] = copysign(Real(1), inverse.z) > 0;
  }

  RL_HD Real at(std::uint32_t axis, Real plane) const {
    if (axis == 0) return (plane - origin.x) * inverse.x;
    if (axis == 1) return (plane - origin.y) * inverse.y;
    return (plane - origin.z) * inverse.z;
  }

  RL_HD bool forward(std::uint32_t axis) const {
    return axis == 0 ? positive[0] : (axis == 1 ? positive[1] : positive[2]);
  }

  /// Whether the ray is in the low child of an inner node at parameter t.
  RL_HD bool below(KdNode n, Real t) const { return (t < at(n.axis(), n.split)) == forward(n.axis()); }

  /// The parameter where the ray leaves a box (min xyz, max xyz) and the face (0…5) through which it does.
  RL_HD Real exit(const float* bounds, std::uint32_t& face) const {
    Real t = infinity;
    face = 6;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      std::uint32_t const f = axis + (forward(axis) ? 3 : 0);
      Real const plane = at(axis, bounds[f]);
      if (plane < t) {
        t = plane;
        face = f;
      }
    }
    return t;
  }

  RL_HD Real enter(const float* bounds) const {
    Real t = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      Real const plane = at(axis, bounds[axis + (forward(axis) ? 0 : 3)]);
      if (plane > t) t = plane;
    }
    return t;
  }
};

RL_HD inline std::uint32_t findLeaf(const KdTreeView& tree, const RayPlanes& planes, std::uint32_t node, Real t) {
  KdNode n = tree.nodes[node];
  while (!n.isLeaf()) {
    node = planes.below(n, t) ? node + 1 : n.target();
    n = tree.nodes[node];
  }
  return n.target();
}

/// Calls test(primitive) for the primitives of every cell along the ray until done(t), where t is the parameter at
/// which the ray leaves the cell just tested. start(planes, t): a node above the cell where the ray enters the tree.
template <class Test, class Done, class Start>
RL_HD void traverseRopes(const KdTreeView& tree, const Ray& ray, Test&& test, Done&& done, Start&& start) {
  RayPlanes const planes(ray);
  std::uint32_t face;
  Real t = planes.enter(tree.bounds);
  if (!(t <= planes.exit(tree.bounds, face))) return;
  std::uint32_t node = start(planes, t);
  while (node != noRope) {
    const KdLeaf& leaf = tree.leaves[findLeaf(tree, planes, node, t)];
    for (std::uint32_t k = 0; k < leaf.count; ++k) test(tree.references[leaf.first + k]);
    t = planes.exit(leaf.bounds, face);
    if (face == 6 || done(t)) return;
    node = leaf.ropes[face];
  }
}

template <class Test, class Done>
RL_HD void traverseRopes(const KdTreeView& tree, const Ray& ray, Test&& test, Done&& done) {
  traverseRopes(tree, ray, test, done, [](const RayPlanes&, Real) { return 0u; });
}

}  // namespace ropelight::RL_TARGET
