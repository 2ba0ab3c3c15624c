#pragma once
// Meshes that rays are timed on: a bumpy sphere of any size or an OBJ file, scaled alike, alone or in a closed room.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/flat/flat_scene.h"

namespace ropelight {

/// A closed longitude–latitude sphere with two scales of bumps, of bumpyTriangles(segments, rows) triangles that face
/// out. Row i lies at θ = πi/(rows − 1) from +y, segment j at φ = 2πj/segments. Coordinates have six significant
/// digits. segments ≥ 3 and rows ≥ 3.
std::vector<FlatTriangle> bumpySphere(int segments, int rows);

/// 2·segments·(rows − 2).
std::uint32_t bumpyTriangles(int segments, int rows);

/// The bumpy sphere whose number of triangles comes closest to `triangles` (≥ 10), within 3%.
std::vector<FlatTriangle> bumpySphereOf(std::uint32_t triangles);

/// The triangles of an OBJ file. Throws Error as loadObj does.
std::vector<FlatTriangle> objTriangles(const std::filesystem::path& path);

/// Moves the centre of the bounding box to the origin, scales the longest half-extent to 1, and rounds to float. Throws
/// Error where all vertices coincide.
void normalise(std::vector<FlatTriangle>& triangles);

/// Appends the room [−2.5, 2.5]³: 12 triangles that face in.
void appendRoom(std::vector<FlatTriangle>& triangles);
inline constexpr std::uint32_t roomTriangles = 12;

/// Triangles alone as a scene to trace rays against: one material, no light.
FlatScene triangleScene(std::vector<FlatTriangle> triangles);

}  // namespace ropelight
