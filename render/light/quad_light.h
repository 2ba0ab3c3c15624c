#pragma once
// Sampling a parallelogram: by area for emission and for direct light from afar; near one that is large against its
// distance, where area sampling would hardly ever find the part that matters, mostly by the cosine to its plane.

#include "render/core/frame.h"
#include "render/core/warp.h"
#include "render/flat/flat_scene.h"
#include "render/intersection/surface.h"
#include "render/light/receiver.h"

namespace ropelight::RL_TARGET {

struct QuadLight {
  static constexpr FeatureBits bit = feature::quads;

  /// Whether the primitive that emits is of this shape.
  static bool holds(const FlatScene& flat, std::uint32_t primitive) { return primitive < flat.quads.size(); }

  RL_HD static const Quad& shape(const SceneView& scene, const Light& light) { return scene.quads[light.primitive]; }

  /// A point uniform by area, on the outer side.
  RL_HD static void samplePoint(const Quad& quad, Vec2 u, Surface& out) { placeOn(quad, u.x, u.y, out); }

  /// A point that the receiver may see, and its density per solid angle there; 0 where there is none. toward: from the
  /// receiver to the point, scene units.
  RL_HD static Real sampleToward(const Quad& quad, Real area, const Receiver& from, Vec2 u, Surface& out,
                                 Vec3& toward) {
    Real const share = cosineShare(quad, area, from.p);
    if (share > 0 && u.x < share) {
      if (!sampleCosine(quad, area, from.p, Vec2(u.x / share, u.y), out, toward)) return 0;
    } else {
      placeOn(quad, share > 0 ? minOf((u.x - share) / (1 - share), 1 - machineEpsilon) : u.x, u.y, out);
      toward = out.p - from.p;
    }
    return density(quad, area, share, toward);
  }

  /// Density per solid angle of sampleToward for the point at `toward` from the receiver.
  RL_HD static Real pdfToward(const Quad& quad, Real area, Vec3 from, const Surface& /*on*/, Vec3 toward) {
    return density(quad, area, cosineShare(quad, area, from), toward);
  }

 private:
  /// The quad's own coordinates of a point of its plane: along b − a and d − a.
  RL_HD static Vec2 coordinates(const Quad& quad, Real area, Vec3 fromCorner) {
    Vec3 const e1 = quad.b - quad.a, e2 = quad.d - quad.a;
    return Vec2(dot(cross(fromCorner, e2), quad.n), dot(cross(e1, fromCorner), quad.n)) / area;
  }

  /// Share of the samples that are taken by the cosine to the plane: 0 where the quad is small against its distance,
  /// nearly 1 where it is huge.
  RL_HD static Real cosineShare(const Quad& quad, Real area, Vec3 from) {
    Real const height = dot(quad.n, from - quad.a);
    if (area <= 4 * height * height) return 0;  // the usual case, at little cost
    Vec2 const st = coordinates(quad, area, from - quad.a);
    Real const s = minOf(maxOf(st.x, Real(0)), Real(1)), t = minOf(maxOf(st.y, Real(0)), Real(1));
    Vec3 const nearest = quad.a + (quad.b - quad.a) * s + (quad.d - quad.a) * t;
    Real const near4 = 4 * lengthSquared(nearest - from);
    return area > near4 ? area / (area + near4) : Real(0);
  }

  /// False where the direction misses the quad.
  RL_HD static bool sampleCosine(const Quad& quad, Real area, Vec3 from, Vec2 u, Surface& out, Vec3& toward) {
    Real const height = dot(quad.n, quad.a - from);
    if (height == 0) return false;
    Vec3 const local = cosineHemisphere(u);
    toward = Frame(height > 0 ? quad.n : -quad.n).toWorld(local) * (abs(height) / local.z);
    Vec2 const st = coordinates(quad, area, (from - quad.a) + toward);
    if (!(st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1)) return false;
    placeOn(quad, st.x, st.y, out);
    return true;
  }

  RL_HD static Real density(const Quad& quad, Real area, Real share, Vec3 toward) {
    Real const distance2 = lengthSquared(toward), distance = sqrt(distance2);
    Real const cosine = abs(dot(quad.n, toward));  // times the distance
    if (!(cosine > 0)) return 0;
    Real const byArea = distance2 * distance / (cosine * area);
    return share > 0 ? (1 - share) * byArea + share * cosineHemispherePdf(cosine / distance) : byArea;
  }
};

}  // namespace ropelight::RL_TARGET
