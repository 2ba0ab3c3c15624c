#!/usr/bin/env bash
# tinyobjloader loses polylines under "g", keeps them under "o", and repeats them at every change of material.
#
# One would guess: an "l" element is read once, whatever groups and materials follow.
# What happens: a group begun with "g" is kept only if it has faces, one begun with "o" also if it has lines; and "usemtl"
#   writes the group's faces out and forgets them, but writes its lines without forgetting them, so that each later change of
#   material, and the end, writes them again. All silently.
# Seen in: 2.0.0rc10.
# ropelight instead: only v and f are read, and the report counts the lines left out.
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

#include <cstdio>
#include <string>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

std::size_t lines(const char* title, const std::string& body) {
  const std::string corners = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  tinyobj::ObjReader reader;
  expect(reader.ParseFromString(corners + body, "newmtl red\nnewmtl blue\n") && reader.Warning().empty() && reader.Error().empty(),
         "no complaint");
  std::size_t count = 0;
  for (const auto& shape : reader.GetShapes()) count += shape.lines.num_line_vertices.size();
  std::printf("%-48s lines written 1, lines read %zu\n", title, count);
  return count;
}

int main() {
  expect(lines("o wire / l / o face / f", "o wire\nl 1 2\no face\nf 1 2 3\n") == 1, "kept under o");
  expect(lines("g wire / l / g face / f", "g wire\nl 1 2\ng face\nf 1 2 3\n") == 0, "lost under g");
  expect(lines("l / f / usemtl red, blue, red, each with an f",
               "l 1 2\nf 1 2 3\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n") == 4,
         "once more for every change of material");
  return failures != 0;
}
CPP
g++ -std=c++17 -Iroot/usr/include main.cpp -o main
./main
