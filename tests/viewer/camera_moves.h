#pragma once
// Cameras to move, and what must hold of them.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "app/viewer/camera/camera_control.h"

namespace ropelight::view {

inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double sizes[] = {1e-9, 1, 1e12};

inline Bounds cube(double half, Vec3d center = Vec3d(0)) { return {center - Vec3d(half), center + Vec3d(half)}; }

inline CameraDesc cameraAt(Vec3d position, Vec3d target = Vec3d(0)) {
  CameraDesc c;
  c.position = position;
  c.target = target;
  return c;
}

inline CameraControl controlOf(const CameraDesc& camera, const Bounds& bounds = cube(1)) {
  CameraControl control;
  control.setHome(camera, bounds);
  return control;
}

/// A camera before a scene of this size.
inline CameraControl sized(double size) { return controlOf(cameraAt(Vec3d(1, 2, 5) * size), cube(size)); }

inline double distance(const CameraDesc& c) { return glm::length(c.target - c.position); }
inline Vec3d forward(const CameraDesc& c) { return glm::normalize(c.target - c.position); }
inline Vec3d right(const CameraDesc& c) { return glm::normalize(glm::cross(forward(c), c.up)); }

/// Where makeCamera's picture shows a point, as shares of width and height from the top left; z: depth.
inline Vec3d project(const CameraDesc& c, Vec3d p, double aspect) {
  Vec3d const d = p - c.position, r = right(c), u = glm::cross(r, forward(c));
  double const depth = glm::dot(d, forward(c)), t = std::tan(glm::radians(c.verticalFov) / 2);
  return {0.5 + 0.5 * glm::dot(d, r) / (depth * t * aspect), 0.5 - 0.5 * glm::dot(d, u) / (depth * t), depth};
}

/// As a scene of one sphere, which the loader's own checks must take.
inline void checkUsable(const CameraDesc& camera) {
  Scene scene;
  scene.camera = camera;
  scene.materials.push_back({"white", DiffuseParams{}});
  scene.shapes.emplace_back();
  CHECK_NOTHROW(validateScene(scene));
}

inline void checkNear(Vec3d a, Vec3d b, double tolerance) { CHECK(glm::length(a - b) <= tolerance); }

}  // namespace ropelight::view
