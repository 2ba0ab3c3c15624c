#pragma once
// Wavefront OBJ → Mesh.

#include <filesystem>
#include <string>

#include "render/scene/scene.h"

namespace ropelight {

/// The triangles of an OBJ file, in file order, polygons cut into fans around their first vertex. Groups, materials,
/// normals and texture coordinates are read past. Throws Error with the line of what is wrong: a coordinate that is not
/// a finite number, a face of fewer than three vertices, an index that names no vertex above it, no faces at all.
/// `remedy` ends the message where the file cannot be read.
Mesh loadObj(const std::filesystem::path& path, const std::string& remedy = "check the path");

}  // namespace ropelight
