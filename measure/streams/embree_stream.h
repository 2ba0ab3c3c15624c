#pragma once
// Embree beside this project's own traversals, where it was built in and the scene is of triangles alone.

#include "measure/streams/ray_stream.h"

namespace ropelight {

/// A stream that answers Traversal::embree itself, on `threads` threads (0: all cores), and leaves all else to `own`;
/// `own` itself where Embree cannot be had. Embree's structure is built when it is first asked for.
std::unique_ptr<RayStream> withEmbree(const StreamScene& scene, int threads, std::unique_ptr<RayStream> own);

}  // namespace ropelight
