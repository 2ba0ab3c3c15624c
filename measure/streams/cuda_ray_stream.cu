#include "render/backend/cuda_backend.h"
// its driver, on that backend:
#include "measure/streams/ray_stream_impl.h"

namespace ropelight::cuda {

std::unique_ptr<RayStream> makeRayStream(const StreamScene& scene, const BackendChoice& choice) {
  return makeStream(scene, choice);
}

}  // namespace ropelight::cuda
