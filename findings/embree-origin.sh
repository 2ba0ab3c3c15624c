#!/usr/bin/env bash
# Embree: the robust mode is the one in which every ray meets the triangle that it starts on.
#
# One would guess: RTC_SCENE_FLAG_ROBUST makes a ray that leaves a surface safer, or at least no worse; with tnear = 0 a hit
#   at t = 0 is either in the interval in both modes or in neither.
# What happens: the default test asks for t > tnear, the robust one for t >= tnear. Rays that start exactly on an axis-parallel
#   triangle meet it at t = 0 never by default, and always in robust mode; so do rays that start from a corner. A shadow ray
#   with tnear = 0 is then always in shadow. tnear has to be raised above 0 for robust scenes.
# Seen in: 3.13.5.
# ropelight instead: its own traversals; Embree is judged on rays that do not start on a surface.
set -euo pipefail

packages=(libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2 libtbb12=2021.8.0-2+deb12u1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

struct Vec {
  float x, y, z;
};
using Triangles = std::vector<std::array<unsigned, 3>>;

RTCScene makeScene(RTCDevice device, const std::vector<Vec>& corners, const Triangles& triangles, bool robust) {
  const RTCScene scene = rtcNewScene(device);
  if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  std::copy(corners.begin(), corners.end(),
            static_cast<Vec*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, corners.size())));
  std::copy(triangles.begin(), triangles.end(),
            static_cast<std::array<unsigned, 3>*>(
                rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size())));
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
  expect(rtcGetDeviceError(device) == RTC_ERROR_NONE, "no error from building");
  return scene;
}

/// The t of the hit in [0, infinity], or -1 for a miss.
float trace(RTCScene scene, Vec from, Vec along) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray = {from.x, from.y, from.z, 0, along.x, along.y, along.z, 0, INFINITY, 0xFFFFFFFFu, 0, 0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &ray);
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : ray.ray.tfar;
}

std::mt19937 generator(1);
float random(float from, float to) { return from + (to - from) * float(generator() >> 8) * 0x1p-24f; }

int main() {
  const RTCDevice device = rtcNewDevice("threads=1");
  std::printf("Embree %ld\n", long(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION)));
  const int rays = 100000;
  for (bool robust : {false, true}) {
    const RTCScene flat = makeScene(device, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, robust);
    const Vec corner = {0.1f, 0.2f, 0.3f};
    const RTCScene skew = makeScene(device, {corner, {0.9f, 0.3f, 0.7f}, {0.2f, 0.8f, 0.9f}}, {{0, 1, 2}}, robust);
    int inside = 0, fromCorner = 0;
    for (int i = 0; i < rays; ++i) {
      const float u = random(0.01f, 0.9f), v = random(0.01f, 0.99f - u);
      inside += trace(flat, {u, v, 0}, {random(-1, 1), random(-1, 1), random(0.1f, 1)}) == 0;
      fromCorner += trace(skew, corner, {random(-1, 1), random(-1, 1), random(-1, 1)}) == 0;
    }
    std::printf("%-8s hits at t = 0 of %d rays: %d from inside a flat triangle, %d from a skew one's corner\n",
                robust ? "robust" : "default", rays, inside, fromCorner);
    expect(inside == (robust ? rays : 0), "all or nothing on the flat triangle");
    expect(robust ? fromCorner > rays * 0.9 : fromCorner == 0, "nearly all or nothing from the corner");
  }
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -O2 -Iroot/usr/include main.cpp -o main -L"$lib" -l:libembree3.so.3 -Wl,-rpath-link,"$lib"
LD_LIBRARY_PATH="$lib" ./main
