#!/usr/bin/env bash
# GLM: intersectRayTriangle meets triangles behind the ray, and none whose edges are below some 3*10^-4.
#
# One would guess: a ray has a beginning, as in intersectRayPlane of the same header, which turns away what lies behind; and
#   whether a triangle is met does not depend on the unit of length.
# What happens: true is returned with a negative distance, and the caller has to look. And the determinant, which shrinks with
#   the square of the edges and with the length of the direction, is compared with the floats' epsilon 1.2*10^-7 as it is:
#   a millimetre's tenth in metres is never met, nor is a unit triangle by a direction shorter than that.
# Seen in: 0.9.9.8.
# ropelight instead: its own watertight test, whose bounds are relative; GLM is there for vectors and matrices alone.
set -euo pipefail

packages=(libglm-dev=0.9.9.8+ds-6)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>

#include <cstdio>
#include <initializer_list>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

/// The right triangle with legs `size`, seen from its side z = `height` along +z.
bool meets(float size, float height, float length, float& distance) {
  glm::vec2 barycentric;
  return glm::intersectRayTriangle(glm::vec3(0.2f * size, 0.2f * size, height), glm::vec3(0, 0, length), glm::vec3(0, 0, 0),
                                   glm::vec3(size, 0, 0), glm::vec3(0, size, 0), barycentric, distance);
}

int main() {
  std::printf("GLM %d.%d.%d.%d\n", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, GLM_VERSION_REVISION);
  float distance = 0, planeDistance = 0;
  const bool behind = meets(1, 5, 1, distance);
  const bool plane = glm::intersectRayPlane(glm::vec3(0, 0, 5), glm::vec3(0, 0, 1), glm::vec3(0), glm::vec3(0, 0, 1), planeDistance);
  std::printf("five units behind the ray: triangle %s (distance %g), its plane %s\n", behind ? "met" : "not met", distance,
              plane ? "met" : "not met");
  expect(behind && distance == -5, "a triangle behind is met");
  expect(!plane, "a plane behind is not");

  for (float size : {1.0f, 1e-2f, 1e-3f, 1e-4f, 1e-5f}) {
    const bool met = meets(size, -1, 1, distance);
    std::printf("edges of %-6g one unit ahead: %s\n", size, met ? "met" : "not met");
    expect(met == (size > 3.4e-4f), "small triangles are not met");
  }
  const bool slow = meets(1, -1, 1e-7f, distance);
  std::printf("edges of 1, direction of length 1e-07: %s\n", slow ? "met" : "not met");
  expect(!slow, "short directions meet nothing");
  return failures != 0;
}
CPP
g++ -std=c++17 -Iroot/usr/include main.cpp -o main
./main
