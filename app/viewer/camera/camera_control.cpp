#include "app/viewer/camera/camera_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ropelight::view {
namespace {

constexpr double poleGap = 1e-3;      // radians between the view and a pole that orbit and look keep
constexpr double leastAngle = 1e-6;   // radians between the view and up that a scene must have
constexpr double leastShare = 1e-9;   // distance to the target over the size of numbers around it
constexpr double frameMargin = 1.05;  // picture over what frame() must show
constexpr double flySeconds = 5;      // for the scene's diagonal at speed 1
constexpr double halfTurn = 1.5707963267948966;

bool finite(Vec3d v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
double largest(Vec3d v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
bool inRange(Vec3d v) { return largest(v) <= maxCoordinate && finite(v); }

/// Unit length without overflow or underflow on the way; zero stays zero.
Vec3d unit(Vec3d v) {
  double const size = largest(v);
  return size > 0 ? glm::normalize(v / size) : v;
}

/// The picture's directions, as makeCamera has them.
struct Axes {
  Vec3d forward, right, up;
  double distance, tangent;

  explicit Axes(const CameraDesc& c)
      : forward(unit(c.target - c.position)),
        right(unit(glm::cross(forward, unit(c.up)))),
        up(glm::cross(right, forward)),
        distance(glm::length(c.target - c.position)),
        tangent(std::tan(glm::radians(c.verticalFov) / 2)) {}
};

/// `forward` turned to the right around `pole` and up, no nearer to a pole than it was or than poleGap.
Vec3d turned(const Axes& axes, Vec3d pole, double right, double up) {
  Vec3d const level = glm::cross(pole, axes.right);
  double const elevation = std::atan2(glm::dot(axes.forward, pole), glm::dot(axes.forward, level));
  double const highest = std::max(halfTurn - poleGap, std::abs(elevation));
  double const angle = std::clamp(elevation + up, -highest, highest);
  Vec3d const heading = level * std::cos(right) + axes.right * std::sin(right);
  return unit(heading * std::cos(angle) + pole * std::sin(angle));
}

/// How far one may go from a point before a coordinate leaves its limits.
double room(Vec3d from, Vec3d direction) {
  double most = 4 * maxCoordinate;
  for (int a = 0; a < 3; ++a)
    if (direction[a] != 0) most = std::min(most, (std::copysign(maxCoordinate, direction[a]) - from[a]) / direction[a]);
  return std::max(most * (1 - 1e-12), 0.0);
}

bool finite(const CameraDesc& c) {
  return finite(c.position) && finite(c.target) && finite(c.up) && std::isfinite(c.verticalFov) &&
         std::isfinite(c.apertureRadius) && std::isfinite(c.focusDistance);
}

void clampNumbers(CameraDesc& c) {
  c.position = glm::clamp(c.position, Vec3d(-maxCoordinate), Vec3d(maxCoordinate));
  c.target = glm::clamp(c.target, Vec3d(-maxCoordinate), Vec3d(maxCoordinate));
  c.verticalFov = std::clamp(c.verticalFov, minFov, maxFov);
  c.apertureRadius = std::clamp(c.apertureRadius, 0.0, maxCoordinate);
  c.focusDistance = std::clamp(c.focusDistance, 0.0, maxCoordinate);
}

/// A camera of finite numbers within the limits, with a direction, and an up that is not along it.
CameraDesc mended(CameraDesc c, double scale) {
  clampNumbers(c);
  double const farthest = std::max(glm::length(c.position), glm::length(c.target));
  if (!(glm::length(c.target - c.position) > 1e-12 * farthest)) {
    double const distance = std::min(std::max(scale, leastShare * farthest), maxCoordinate);
    c.target = c.position + Vec3d(0, 0, c.position.z >= 0 ? -distance : distance);
  }
  Vec3d const forward = unit(c.target - c.position);
  bool const usable = inRange(c.up) && glm::length(c.up) > 0;
  if (!usable || !(glm::length(glm::cross(forward, unit(c.up))) > leastAngle))
    c.up = std::abs(forward.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  return c;
}

/// Distance from the bounds' middle from which all eight corners lie in the picture.
double distanceToSee(const Bounds& bounds, const Axes& axes, double aspect) {
  Vec3d const half = bounds.extent() / 2.0;
  double distance = 0.55 * 2 * glm::length(half);  // before every corner, also where the angle is wide
  for (int i = 0; i < 8; ++i) {
    Vec3d const corner = half * Vec3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    double const across = std::abs(glm::dot(corner, axes.right)) / aspect;
    double const along = std::max(across, std::abs(glm::dot(corner, axes.up))) / axes.tangent;
    distance = std::max(distance, frameMargin * along - glm::dot(corner, axes.forward));
  }
  return distance;
}

std::string text(double x) { return nlohmann::json(x).dump(); }
std::string text(Vec3d v) { return fmt::format("[{}, {}, {}]", text(v.x), text(v.y), text(v.z)); }

}  // namespace

void CameraControl::setHome(const CameraDesc& home, const Bounds& bounds) {
  double const diagonal = bounds.empty() ? 0 : glm::length(bounds.extent());
  double const distance = finite(home) ? glm::length(home.target - home.position) : 0;
  scale_ = diagonal > 0 && std::isfinite(diagonal) ? diagonal : distance > 0 ? distance : 1;
  home_ = mended(finite(home) ? home : CameraDesc{}, scale_);
  reset();
}

void CameraControl::reset() { camera_ = home_; }

void CameraControl::setCamera(const CameraDesc& camera) {
  if (finite(camera)) camera_ = mended(camera, scale_);
}

/// Both must be within the limits, and apart.
void CameraControl::accept(Vec3d position, Vec3d target) {
  if (!inRange(position) || !inRange(target)) return;
  double const farthest = std::max(glm::length(position), glm::length(target));
  Vec3d const view = target - position;
  if (!(glm::length(view) > 1e-12 * farthest)) return;
  if (!(glm::length(glm::cross(unit(view), unit(camera_.up))) > leastAngle)) return;
  camera_.position = position;
  camera_.target = target;
}

void CameraControl::translate(Vec3d offset) { accept(camera_.position + offset, camera_.target + offset); }

double CameraControl::leastDistance(Vec3d target) const { return leastShare * std::max(largest(target), scale_); }

void CameraControl::orbit(double right, double up) {
  if (!std::isfinite(right) || !std::isfinite(up)) return;
  Axes const axes(camera_);
  // Moving to the right while looking at the same point turns the view to the left.
  Vec3d const forward = turned(axes, unit(camera_.up), -right, -up);
  accept(camera_.target - forward * axes.distance, camera_.target);
}

void CameraControl::pan(double right, double up) {
  if (!std::isfinite(right) || !std::isfinite(up)) return;
  Axes const axes(camera_);
  translate((axes.right * right + axes.up * up) * (2 * axes.distance * axes.tangent));
}

void CameraControl::dolly(double amount) {
  if (!std::isfinite(amount)) return;
  Axes const axes(camera_);
  double const least = std::min(leastDistance(camera_.target), axes.distance);
  double const most = std::max(room(camera_.target, -axes.forward), axes.distance);
  double const distance = std::clamp(axes.distance * std::exp(-amount), least, most);
  accept(camera_.target - axes.forward * distance, camera_.target);
}

void CameraControl::look(double right, double up) {
  if (!std::isfinite(right) || !std::isfinite(up)) return;
  Axes const axes(camera_);
  accept(camera_.position, camera_.position + turned(axes, unit(camera_.up), right, up) * axes.distance);
}

void CameraControl::fly(Vec3d direction, double seconds) {
  if (!finite(direction) || !std::isfinite(seconds) || !std::isfinite(speed)) return;
  Axes const axes(camera_);
  Vec3d const d = glm::clamp(direction, Vec3d(-1), Vec3d(1)) * (speed * scale_ / flySeconds * seconds);
  translate(axes.right * d.x + axes.up * d.y + axes.forward * d.z);
}

void CameraControl::setFov(double degrees) {
  if (std::isfinite(degrees)) camera_.verticalFov = std::clamp(degrees, minFov, maxFov);
}

void CameraControl::setAperture(double radius) {
  if (std::isfinite(radius)) camera_.apertureRadius = std::clamp(radius, 0.0, maxCoordinate);
}

void CameraControl::setFocusDistance(double distance) {
  if (std::isfinite(distance)) camera_.focusDistance = std::clamp(distance, 0.0, maxCoordinate);
}

void CameraControl::frame(const Bounds& bounds, double aspect) {
  if (bounds.empty() || !inRange(bounds.min) || !inRange(bounds.max)) return;
  if (!(aspect > 0) || !std::isfinite(aspect)) return;
  Axes const axes(camera_);
  Vec3d const middle = bounds.min + bounds.extent() / 2.0;
  double distance = distanceToSee(bounds, axes, aspect);
  if (!(distance > 0)) distance = axes.distance;  // a point is seen from anywhere
  distance = std::min(std::max(distance, leastDistance(middle)), room(middle, -axes.forward));
  accept(middle - axes.forward * distance, middle);
}

Vec3d CameraControl::directionThrough(double x, double y, double aspect) const {
  Axes const axes(camera_);
  Vec3d const across = axes.right * (axes.tangent * aspect * (2 * x - 1));
  Vec3d const d = axes.forward + across + axes.up * (axes.tangent * (1 - 2 * y));
  return finite(d) ? unit(d) : axes.forward;
}

std::string cameraJson(const CameraDesc& c) {
  return fmt::format(
      "{{\n  \"position\": {},\n  \"target\": {},\n  \"up\": {},\n  \"fov\": {},\n  \"aperture\": {},\n  \"focus\": "
      "{}\n}}",
      text(c.position), text(c.target), text(c.up), text(c.verticalFov), text(c.apertureRadius), text(c.focusDistance));
}

}  // namespace ropelight::view
