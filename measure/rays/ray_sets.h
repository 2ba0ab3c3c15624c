#pragma once
// Sets of rays from coherent to scattered, the same ones wherever they are made: camera rays, their bounces and shadow
// rays, and light paths. Random numbers are a hash of the ray's number and the dimension.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "measure/streams/ray_stream.h"

namespace ropelight {

/// A pinhole camera (y up, full vertical angle in degrees) and a horizontal square light that faces down and is no
/// geometry. Lengths in scene units.
struct RayView {
  Vec3d eye, target;
  double verticalFov;
  double lightHeight, lightHalf;
};

inline constexpr RayView outsideView{{1.0, 0.7, 2.3}, {0, 0, 0}, 50, 2.45, 0.5};
inline constexpr RayView insideView{{0.25, 0.15, 0.35}, {0, 0, -0.8}, 75, 0.6, 0.15};

/// Pixels in tiles of 8 × 4, tiles row by row; a multiple of that in either direction.
struct RayImage {
  int width = 1920, height = 1080;

  std::uint32_t rays() const { return std::uint32_t(width) * std::uint32_t(height); }
};

struct RaySet {
  std::string name;
  std::vector<StreamRay> rays;
  std::vector<StreamHit> hits;  ///< the closest, of the tracer
  bool anyHit = false;
};

/// The closest hits of rays in (0, tMax].
using RayTracer = std::function<std::vector<StreamHit>(std::span<const StreamRay>)>;

/// The sets, in this order. diffuse1, shadow1: from the hits of primary; diffuse2: from those of diffuse1; photon0:
/// from the light; photon1: from the hits of photon0.
inline constexpr const char* raySetNames[] = {"primary", "diffuse1", "shadow1", "diffuse2", "photon0", "photon1"};

/// All sets of the rays with these numbers (each below image.rays()). The scene holds triangles alone. A ray whose
/// forerunner hit nothing has tMax 0 and hits nothing. Bounces are diffuse (cosine; basis of Duff et al. 2017).
std::vector<RaySet> makeRaySets(const FlatScene& scene, const RayView& view, const RayImage& image,
                                std::span<const std::uint32_t> numbers, const RayTracer& trace);

/// Of all rays of the image.
std::vector<RaySet> makeRaySets(const FlatScene& scene, const RayView& view, const RayImage& image,
                                const RayTracer& trace);

/// Uniform in [0, 1) with 24 bits.
float rayRandom(std::uint32_t ray, std::uint32_t dimension);

}  // namespace ropelight
