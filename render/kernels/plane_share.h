#pragma once
// How much of a disc lies where photons can land: on flat surfaces the density of photons is their flux over that area,
// not over the whole disc, so that nothing darkens towards the edges of a wall.

#include "render/core/frame.h"
#include "render/intersection/scene_view.h"

namespace ropelight::RL_TARGET {

/// Twice the area, with its sign, that the disc of squared radius r2 about the origin shares with the triangle
/// (0, p, q).
RL_HD inline Real discTriangle(Vec2 p, Vec2 q, Real r2) {
  auto const cross2 = [](Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; };
  auto const sector = [&](Vec2 a, Vec2 b) { return r2 * atan2(cross2(a, b), a.x * b.x + a.y * b.y); };
  Vec2 const d = q - p;
  Real const a = d.x * d.x + d.y * d.y, b = p.x * d.x + p.y * d.y, c = p.x * p.x + p.y * p.y - r2;
  Real const root2 = b * b - a * c;
  if (!(a > 0)) return 0;
  if (!(root2 > 0)) return sector(p, q);
  Real const root = sqrt(root2), t0 = (-b - root) / a, t1 = (-b + root) / a;
  if (t1 <= 0 || t0 >= 1) return sector(p, q);
  Vec2 const in = t0 > 0 ? p + d * t0 : p, out = t1 < 1 ? p + d * t1 : q;
  return (t0 > 0 ? sector(p, in) : Real(0)) + cross2(in, out) + (t1 < 1 ? sector(out, q) : Real(0));
}

/// The quads of a scene as gathers see them: pieces [first[k], first[k + 1]) belong to quad k, the quad itself before
/// what stands on it.
struct PlaneView {
  Span<const PlanePiece> pieces;
  Span<const std::uint32_t> first;

  /// Whether the primitive is a quad that is known.
  RL_HD bool knows(std::uint32_t primitive) const { return first.size > 0 && primitive < first.size - 1; }

  /// Whether the disc about p lies on the quad, away from its edges.
  RL_HD bool surrounds(std::uint32_t quad, Vec3 p, Real radius) const { return depth(quad, p) >= radius; }

  /// Whether the point, near the quad's plane, is above the quad.
  RL_HD bool holds(std::uint32_t quad, Vec3 p) const { return depth(quad, p) >= 0; }

  /// The share of the disc about p with normal n (unit, towards the side that is seen) on which photons can land, in
  /// (0, 1].
  RL_HD Real share(std::uint32_t quad, Vec3 p, Vec3 n, Real radius) const {
    Real const full = pi * square(radius);
    std::uint32_t const begin = first[quad], end = first[quad + 1];
    bool const within = surrounds(quad, p, radius);
    if (within && end == begin + 1) return 1;
    Frame const frame(n);
    Real area = within ? full : shared(pieces[begin], p, frame, square(radius));
    for (std::uint32_t k = begin + 1; k < end; ++k) {
      const PlanePiece& piece = pieces[k];
      if (!(dot(piece.covers, n) > 0) || lengthSquared(p - piece.center) > square(piece.reach + radius)) continue;
      area -= shared(piece, p, frame, square(radius));
    }
    return minOf(maxOf(area / full, Real(1e-3)), Real(1));
  }

 private:
  /// Distance from the nearest edge's line; negative outside.
  RL_HD Real depth(std::uint32_t quad, Vec3 p) const {
    const PlanePiece& piece = pieces[first[quad]];
    Real least = infinity;
    for (int k = 0; k < 4; ++k) {
      Vec3 const a = piece.corner[k], e = piece.corner[(k + 1) & 3] - a;
      least = minOf(least, dot(cross(piece.normal, e), p - a) / sqrt(lengthSquared(e)));
    }
    return least;
  }

  RL_HD static Real shared(const PlanePiece& piece, Vec3 p, const Frame& frame, Real r2) {
    Real twice = 0;
    Vec3 const last = frame.toLocal(piece.corner[3] - p);
    Vec2 from(last.x, last.y);
    for (int k = 0; k < 4; ++k) {
      Vec3 const corner = frame.toLocal(piece.corner[k] - p);
      Vec2 const to(corner.x, corner.y);
      twice += discTriangle(from, to, r2);
      from = to;
    }
    return abs(twice) / 2;
  }
};

}  // namespace ropelight::RL_TARGET
