#!/usr/bin/env bash
# Embree: a triangle 10^13 units large is met at t = infinity, one of 2*10^18 is not there, and one of 10^-15 is met 40% too far.
#
# One would guess: coordinates are floats, so that sizes far within 10^±38 work, or are refused with an error.
# What happens: t is a quotient of products of three coordinates, which leave the floats' range from about 10^13 on (a valid
#   geomID with tfar = infinity) and below some 10^-14 (t wrong, then 0 or a miss). Triangles beyond 1.8*10^18 are left out
#   of the tree. Building and tracing report no error at any size.
# Seen in: 3.13.5.
# ropelight instead: refuses coordinates beyond 10^14 with the path of the shape; that its own products leave the floats'
#   range from some 10^9 on is among the known limits in docs/decisions.md.
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

int main() {
  const RTCDevice device = rtcNewDevice("threads=1");
  std::printf("Embree %ld; a right triangle of the size s, seen from the distance s\n",
              long(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION)));
  for (float s : {1e-17f, 1e-15f, 1e-12f, 1.0f, 1e12f, 1e13f, 1e18f, 2e18f}) {
    float found[2];
    for (bool robust : {false, true}) {
      const RTCScene scene = makeScene(device, {{0, 0, 0}, {s, 0, 0}, {0, s, 0}}, {{0, 1, 2}}, robust);
      const float t = trace(scene, {0.2f * s, 0.2f * s, -s}, {0, 0, 1});
      found[robust] = t < 0 ? -1 : t / s;
      if (t < 0)
        std::printf("s = %-7g %-8s missed\n", s, robust ? "robust" : "default");
      else
        std::printf("s = %-7g %-8s t / s = %g\n", s, robust ? "robust" : "default", found[robust]);
    }
    expect(rtcGetDeviceError(device) == RTC_ERROR_NONE, "no error");
    for (float t : found) {
      if (s >= 1e-12f && s <= 1e12f) expect(std::abs(t - 1) < 1e-3f, "right in between");
      if (s == 1e13f || s == 1e18f) expect(std::isinf(t), "a hit at infinity");
      if (s == 2e18f) expect(t == -1, "left out");
      if (s == 1e-15f) expect(t > 1.2f || (t >= 0 && t < 0.8f), "a wrong t");
    }
    if (s == 1e-17f) expect(found[0] == -1 && found[1] == 0, "missed by default, at t = 0 when robust");
  }
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -O2 -Iroot/usr/include main.cpp -o main -L"$lib" -l:libembree3.so.3 -Wl,-rpath-link,"$lib"
LD_LIBRARY_PATH="$lib" ./main
