#pragma once
// Which way a mesh's triangles face.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace ropelight {

/// Reverses every triangle.
void flip(Mesh& mesh);

/// The volume that a mesh encloses, in cubic units of its own space: negative where its triangles face inwards. Nothing
/// where it is open: where some edge is not used as often in one direction as in the other, vertices in the same place
/// being one.
std::optional<double> enclosedVolume(const Mesh& mesh);

/// A line for every shape whose material refracts and whose closed mesh faces inwards, so that its inside is taken for
/// its outside.
std::vector<std::string> windingNotes(const Scene& scene);

}  // namespace ropelight
