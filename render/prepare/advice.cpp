#include "render/prepare/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/prepare/first_radius.h"

namespace ropelight {
namespace {

constexpr double leastOfFootprint = 0.01;
constexpr double singleEpsilon = std::numeric_limits<float>::epsilon() / 2;

std::string rangeText(const RadiusRange& range) {
  return fmt::format("radii from {:.2g} to {:.2g} make sense here", range.least, range.most);
}

}  // namespace

double smallestDisc(const FlatScene& flat, double epsilon) { return flat.reach * 96 * epsilon; }

RadiusRange sensibleRadius(const Prepared& p) {
  const Bounds& bounds = p.flat->bounds;
  Vec3d const centre = 0.5 * (bounds.min + bounds.max);
  double const distance =
      std::min(glm::length(centre - p.camera.position), glm::length(p.camera.target - p.camera.position));
  double const most = glm::length(bounds.extent());
  double const least = std::max(leastOfFootprint * pixelFootprint(p, distance), smallestDisc(*p.flat, singleEpsilon));
  return {std::min(least, most), most};
}

std::vector<std::string> adviceOn(const Prepared& p) {
  std::vector<std::string> advice;
  if (!(p.features & feature::photons)) return advice;
  const Settings& s = p.settings;
  RadiusRange const range = sensibleRadius(p);
  if (p.requested.radius > 0 && p.requested.radius < range.least)
    advice.push_back(
        fmt::format("--radius {:g} is far below a pixel's footprint: hardly a disc will hold a photon, and "
                    "the light that photons carry stays black; {}",
                    p.requested.radius, rangeText(range)));
  if (p.requested.radius > range.most)
    advice.push_back(
        fmt::format("--radius {:g} is larger than the scene: every disc holds all photons, which is slow "
                    "and blurs their light over everything; {}",
                    p.requested.radius, rangeText(range)));
  if ((p.features & feature::nearest) && s.photons < std::uint64_t(s.nearest))
    advice.push_back(
        fmt::format("--nearest {} asks for more photons than --photons {} emits; ask for fewer, or emit more",
                    s.nearest, s.photons));
  return advice;
}

}  // namespace ropelight
