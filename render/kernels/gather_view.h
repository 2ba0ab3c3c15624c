#pragma once
// Which photons count at a gather point.

#include "accel/photon_grid/photon_grid.h"
#include "render/kernels/plane_share.h"
#include "render/kernels/trace_camera.h"

namespace ropelight::RL_TARGET {

/// Height of the disc over its radius: photons of a wall nearer than this are told apart once the radius has shrunk.
inline constexpr Real discThickness = Real(0.2);
/// Photons count where their surface turns from the gather point's by less than acos of this.
inline constexpr Real sameSide = Real(0.1);

/// On a quad only the quad's photons count.
inline constexpr Real samePlane = Real(0.9998);

/// flux: of the photons over the disc. count: photons found. radius2: squared radius of the disc. share: of the disc,
/// on which photons can land.
struct Gathering {
  Rgb flux{0.0f};
  std::uint32_t count = 0;
  Real radius2 = 0;
  Real share = 1;
};

struct GatherView {
  PhotonGrid grid;
  Real radius = 0;
  int maxDepth = 0;
  PlaneView planes = {};
  Real planeScale = 1;  ///< by which the radius is larger on quads, whose discs are cut at edges

  /// With the radius that the gather point's surface has.
  RL_HD GatherView on(const GatherPoint& g) const {
    GatherView here = *this;
    if (planes.knows(g.surface)) here.radius = radius * planeScale;
    return here;
  }

  /// Whether the photon lies within the disc, and its squared distance from the axis. Always the same for the same
  /// arguments: no compiler may round it one way here and another way there.
  RL_HD bool onDisc(const GatherPoint& g, const PhotonPosition& photon, Real& distance2) const {
    Vec3 const d = photon.p - g.p;
    Real const height = mulAdd(d.z, g.n.z, mulAdd(d.y, g.n.y, d.x * g.n.x));
    Real const inPlane = mulAdd(-height, height, mulAdd(d.z, d.z, mulAdd(d.y, d.y, d.x * d.x)));
    distance2 = maxOf(inPlane, Real(0));
    return (inPlane <= radius * radius) & ((abs(height) <= discThickness * radius) | faulty(Fault::discHeight));
  }

  /// Calls take(k, squared distance, power) for every photon k that counts at a squared distance of up to `most`, and
  /// perhaps for farther ones.
  template <class Take>
  RL_HD void forEachOnDisc(const GatherPoint& g, Real most, Take&& take) const {
    bool const edge = planes.knows(g.surface) && !planes.surrounds(g.surface, g.p, sqrt(most));
    grid.forEachNear(
        neighbourhood(g, most),
        [&](const PhotonPosition& photon, Real& distance2) { return onDisc(g, photon, distance2); },
        [&](std::uint32_t k, Real distance2, const PhotonPosition& photon) {
          PhotonPower const power = grid.powers[k];
          if (counts(g, photon, power) && (!edge || planes.holds(g.surface, photon.p))) take(k, distance2, power);
        });
  }

  /// Whether a photon within the disc belongs to its surface and its path is short enough.
  RL_HD bool counts(const GatherPoint& g, const PhotonPosition& photon, const PhotonPower& power) const {
    return power.edges() + g.edges <= std::uint32_t(maxDepth) && sameSurface(g, photon);
  }

  /// Of the disc about a gather point, on which photons can land.
  RL_HD Real share(const GatherPoint& g, Real radius2) const {
    return planes.knows(g.surface) && !faulty(Fault::wholeDisc) ? planes.share(g.surface, g.p, g.n, sqrt(radius2))
                                                                : Real(1);
  }

 private:
  RL_HD bool sameSurface(const GatherPoint& g, const PhotonPosition& photon) const {
    if (faulty(Fault::otherSide)) return true;
    if (photon.normal == g.packedNormal) return true;  // the usual case, without decoding
    Vec3 const n = unpackOctahedron(photon.normal);
    Real const cosine = dot(n, g.n);
    Real const least = planes.knows(g.surface) ? samePlane : sameSide;
    return cosine > 0 && cosine * cosine > square(least) * lengthSquared(n);
  }

  /// The disc with its thickness: tilted, it reaches up to 2% farther than its radius.
  RL_HD Neighbourhood neighbourhood(const GatherPoint& g, Real most) const {
    Vec3 const n2 = g.n * g.n;
    Vec3 const across(sqrt(n2.y + n2.z), sqrt(n2.z + n2.x), sqrt(n2.x + n2.y));
    Real const thickness = discThickness * radius;
    return {g.p, across * sqrt(most) + absolute(g.n) * thickness, most + square(thickness)};
  }
};

/// All photons within the radius, over its full disc; added up in the order of the grid.
RL_HD inline Gathering gatherDisc(const GatherView& anywhere, const GatherPoint& g) {
  GatherView const view = anywhere.on(g);
  Gathering sum;
  sum.radius2 = square(view.radius);
  view.forEachOnDisc(g, sum.radius2, [&](std::uint32_t, Real, const PhotonPower& power) {
    sum.flux += power.flux;
    ++sum.count;
  });
  sum.share = view.share(g, sum.radius2);
  return sum;
}

}  // namespace ropelight::RL_TARGET
