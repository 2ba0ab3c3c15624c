#include "render/backend/cuda_backend.h"
// its driver, on that backend:
#include "measure/streams/gather_stream_impl.h"

namespace ropelight::cuda {

std::unique_ptr<GatherStream> makeGatherStream(const BackendChoice& choice) {
  return std::make_unique<GatherStreamOn<Backend>>(choice);
}

}  // namespace ropelight::cuda
