#include "measure/rays/ray_sets.h"

#include <cmath>
#include <numeric>

#include "render/core/frame.h"
#include "render/core/rng.h"

namespace ropelight {
namespace {

constexpr float unlimited = 1e16f;  // scene units
constexpr double surfaceOffset = 1e-4;

StreamRay toRay(Vec3d origin, Vec3d direction, double tMax = unlimited) {
  StreamRay ray{};
  for (int a = 0; a < 3; ++a) {
    ray.origin[a] = float(origin[a]);
    ray.direction[a] = float(direction[a]);
  }
  ray.tMax = float(tMax);
  return ray;
}

StreamRay noRay() { return toRay(Vec3d(0.0), {0, 0, 1}, 0); }

Vec3d toVector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

/// The cosine-weighted direction around n of two random numbers.
Vec3d cosineDirection(Vec3d n, double u1, double u2) {
  double const r = std::sqrt(u1), phi = 2 * M_PI * u2, z = std::sqrt(1 - u1);
  cpu::Frame const frame{cpu::Vec3(n)};
  return r * std::cos(phi) * Vec3d(frame.s) + r * std::sin(phi) * Vec3d(frame.t) + z * n;
}

struct Surface {
  Vec3d position;  ///< moved off the surface
  Vec3d normal;    ///< turned against the ray
};

Surface surfaceOf(const FlatScene& scene, const StreamRay& ray, const StreamHit& hit) {
  const FlatTriangle& triangle = scene.triangles[hit.primitive];
  Vec3d const d = toVector(ray.direction);
  Vec3d n = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
  if (glm::dot(n, d) > 0) n = -n;
  return {toVector(ray.origin) + double(hit.t) * d + surfaceOffset * n, n};
}

class Camera {
 public:
  Camera(const RayView& view, const RayImage& image) : eye_(view.eye), image_(image) {
    forward_ = glm::normalize(view.target - view.eye);
    double const half = std::tan(view.verticalFov * M_PI / 360);
    Vec3d const right = glm::normalize(glm::cross(forward_, Vec3d(0, 1, 0)));
    up_ = half * glm::cross(right, forward_);
    right_ = half * image.width / image.height * right;
  }

  StreamRay ray(std::uint32_t number) const {
    std::uint32_t const tile = number / 32, lane = number % 32, across = std::uint32_t(image_.width) / 8;
    double const x = 8 * (tile % across) + (lane & 7), y = 4 * (tile / across) + (lane >> 3);
    return toRay(eye_, glm::normalize(forward_ + (2 * (x + 0.5) / image_.width - 1) * right_ +
                                      (1 - 2 * (y + 0.5) / image_.height) * up_));
  }

 private:
  Vec3d eye_, forward_, right_, up_;
  RayImage image_;
};

Vec3d lightPoint(const RayView& view, std::uint32_t ray, std::uint32_t dimension) {
  auto const across = [&](std::uint32_t d) { return view.lightHalf * (2 * double(rayRandom(ray, d)) - 1); };
  return {across(dimension), view.lightHeight, across(dimension + 1)};
}

StreamRay lightRay(const RayView& view, std::uint32_t ray) {
  return toRay(lightPoint(view, ray, 100),
               cosineDirection({0, -1, 0}, double(rayRandom(ray, 102)), double(rayRandom(ray, 103))));
}

/// Makes sets from the hits of earlier ones.
class SetMaker {
 public:
  SetMaker(const FlatScene& scene, std::span<const std::uint32_t> numbers, const RayTracer& trace)
      : scene_(scene), numbers_(numbers), trace_(trace) {}

  template <class MakeRay>
  RaySet make(const char* name, bool anyHit, MakeRay makeRay) const {
    RaySet set;
    set.name = name;
    set.anyHit = anyHit;
    set.rays.reserve(numbers_.size());
    for (std::size_t k = 0; k < numbers_.size(); ++k) set.rays.push_back(makeRay(k, numbers_[k]));
    set.hits = trace_(set.rays);
    return set;
  }

  /// Rays from where those of `before` hit; next(surface, number) makes one.
  template <class Next>
  RaySet makeFrom(const RaySet& before, const char* name, bool anyHit, Next next) const {
    return make(name, anyHit, [&](std::size_t k, std::uint32_t number) {
      return before.hits[k].found() ? next(surfaceOf(scene_, before.rays[k], before.hits[k]), number) : noRay();
    });
  }

  RaySet bounce(const RaySet& before, const char* name, std::uint32_t dimension) const {
    return makeFrom(before, name, false, [&](const Surface& s, std::uint32_t number) {
      double const u1 = double(rayRandom(number, dimension)), u2 = double(rayRandom(number, dimension + 1));
      return toRay(s.position, cosineDirection(s.normal, u1, u2));
    });
  }

  RaySet shadow(const RaySet& before, const char* name, const RayView& view) const {
    return makeFrom(before, name, true, [&](const Surface& s, std::uint32_t number) {
      Vec3d const towards = lightPoint(view, number, 2) - s.position;
      double const distance = glm::length(towards);
      return toRay(s.position, towards / distance, distance * (1 - 1e-4));
    });
  }

 private:
  const FlatScene& scene_;
  std::span<const std::uint32_t> numbers_;
  const RayTracer& trace_;
};

}  // namespace

float rayRandom(std::uint32_t ray, std::uint32_t dimension) {
  return cpu::toUnit(cpu::hash32(cpu::hash32(ray) + dimension * 0x9E3779B9u));
}

std::vector<RaySet> makeRaySets(const FlatScene& scene, const RayView& view, const RayImage& image,
                                std::span<const std::uint32_t> numbers, const RayTracer& trace) {
  SetMaker const maker(scene, numbers, trace);
  Camera const camera(view, image);
  std::vector<RaySet> sets(6);
  sets[0] = maker.make("primary", false, [&](std::size_t, std::uint32_t number) { return camera.ray(number); });
  sets[1] = maker.bounce(sets[0], "diffuse1", 0);
  sets[2] = maker.shadow(sets[0], "shadow1", view);
  sets[3] = maker.bounce(sets[1], "diffuse2", 10);
  sets[4] = maker.make("photon0", false, [&](std::size_t, std::uint32_t number) { return lightRay(view, number); });
  sets[5] = maker.bounce(sets[4], "photon1", 110);
  return sets;
}

std::vector<RaySet> makeRaySets(const FlatScene& scene, const RayView& view, const RayImage& image,
                                const RayTracer& trace) {
  std::vector<std::uint32_t> numbers(image.rays());
  std::iota(numbers.begin(), numbers.end(), 0u);
  return makeRaySets(scene, view, image, numbers, trace);
}

}  // namespace ropelight
