#!/usr/bin/env bash
# tinyobjloader cuts concave polygons by their first corner, their direction and their place.
#
# One would guess: the triangles of a simple planar polygon cover it, whichever corner the face starts with and wherever
#   it stands; where that fails, there is a warning.
# What happens: a corner counts as convex where its turn has the sign of (first x second)/2 of its own edge, which is the
#   area of a triangle with the ORIGIN and not of the polygon. So a pentagon of area 10 becomes triangles of 4, 10, 14 or 22,
#   and clockwise, one unit from the origin, no triangles at all. No warning, no error. A dart of four corners is cut along
#   the shorter diagonal, be that outside of it.
# Seen in: 2.0.0rc10.
# ropelight instead: polygons are cut on whole numbers in the plane of Newell's normal (docs/decisions.md, Meshes).
set -euo pipefail

packages=(libtinyobjloader-dev=2.0.0~rc10+dfsg-2+b1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

using Outline = std::vector<std::pair<int, int>>;

struct Cut {
  double area = 0;
  std::size_t triangles = 0;
};

/// The outline moved by `move` along x and y, as one face from corner `first` on.
Cut cut(const Outline& outline, int move, int first, bool clockwise) {
  const int count = int(outline.size());
  std::string text;
  for (const auto& [x, y] : outline) text += "v " + std::to_string(x + move) + " " + std::to_string(y + move) + " 0\n";
  text += "f";
  for (int i = 0; i < count; ++i) {
    const int corner = clockwise ? first - i + count : first + i;
    text += " " + std::to_string(corner % count + 1);
  }
  tinyobj::ObjReader reader;
  expect(reader.ParseFromString(text + "\n", "") && reader.Error().empty() && reader.Warning().empty(), "no complaint");
  Cut result;
  for (const auto& shape : reader.GetShapes()) {
    const auto& index = shape.mesh.indices;
    result.triangles += index.size() / 3;
    for (std::size_t i = 0; i + 2 < index.size(); i += 3) {
      const auto at = [&](std::size_t k, int axis) {
        return double(reader.GetAttrib().vertices[std::size_t(3 * index[i + k].vertex_index + axis)]);
      };
      result.area += std::abs((at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1))) / 2;
    }
  }
  return result;
}

std::vector<double> row(const char* title, const Outline& outline, int move, bool clockwise) {
  std::vector<double> areas;
  std::printf("%-42s", title);
  for (int first = 0; first < int(outline.size()); ++first) {
    const Cut result = cut(outline, move, first, clockwise);
    areas.push_back(result.area);
    std::printf("  %g (%zu)", result.area, result.triangles);
  }
  std::printf("\n");
  return areas;
}

int main() {
  const Outline pentagon = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};  // area 10
  const Outline dart = {{0, 0}, {3, 1}, {0, 2}, {1, 1}};              // area 2
  using Row = std::vector<double>;
  std::printf("area (triangles) by first corner\n");
  expect(row("pentagon of area 10", pentagon, 0, false) == Row{10, 10, 22, 10, 10}, "by the first corner");
  expect(row("the same clockwise", pentagon, 0, true) == Row{14, 14, 14, 14, 4}, "by the direction");
  expect(row("moved by (-2, -2)", pentagon, -2, false) == Row{14, 14, 22, 14, 14}, "by the place");
  expect(row("moved by (1, 1), clockwise", pentagon, 1, true) == Row{0, 0, 0, 0, 0}, "lost without a word");
  expect(row("dart of area 2", dart, 0, false) == Row{2, 4, 2, 4}, "the shorter diagonal, outside");
  return failures != 0;
}
CPP
g++ -std=c++17 -Iroot/usr/include main.cpp -o main
./main
