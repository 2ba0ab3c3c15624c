#pragma once
// Wavefront OBJ → Mesh.

#include <filesystem>
#include <string>

#include "render/scene/scene.h"

namespace ropelight {

/// The triangles of an OBJ file, in file order, polygons cut as polygon.h says; faces without an area are dropped.
/// Groups, materials, normals, texture coordinates and keywords that mean nothing here are skipped; Mesh::report counts
/// what was dropped or approximated. Throws Error with the line of what is wrong: a coordinate that is not a number or
/// beyond maxCoordinate, a face of fewer than three vertices, an index that names no vertex above it; and where no face
/// has an area. `remedy` ends the message where the file cannot be read.
Mesh loadObj(const std::filesystem::path& path, const std::string& remedy = "check the path");

}  // namespace ropelight
