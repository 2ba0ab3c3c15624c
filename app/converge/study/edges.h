#pragma once
// Where gather discs are cut by edges: there SPPM's error falls more slowly than elsewhere.

#include <vector>

#include "app/converge/analysis/study.h"
#include "render/scene/scene.h"

namespace ropelight {

/// For each pixel whether it sees a point within `radius` (scene units) of an edge, as far as the picture shows it:
/// nearer than the radius's size in pixels there to a place where the normal turns by more than 25° or the depth jumps
/// by a tenth between neighbours. `normal`, `depth`: the AOVs of the first hit.
std::vector<bool> nearEdges(const Image& normal, const Image& depth, const CameraDesc& camera, double radius);

/// Of the mask's pixels.
EdgeShare edgeShare(const Image& image, const StudyReference& reference, const std::vector<bool>& mask);

}  // namespace ropelight
