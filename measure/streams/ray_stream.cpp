#include "measure/streams/ray_stream.h"

#include "measure/streams/embree_stream.h"

#include "render/backend/cpu_backend.h"
// its driver, on that backend:
#include "measure/streams/ray_stream_impl.h"

namespace ropelight {

#if ROPELIGHT_CUDA
namespace cuda {
std::unique_ptr<RayStream> makeRayStream(const StreamScene& scene, const BackendChoice& choice);
}
#endif

std::unique_ptr<RayStream> makeRayStream(const StreamScene& scene, const BackendChoice& choice) {
  ChosenBackend const chosen = chooseBackend(choice);
  BackendChoice resolved = choice;
  resolved.gpu = chosen.gpu;
#if ROPELIGHT_CUDA
  if (chosen.cuda) return cuda::makeRayStream(scene, resolved);
#endif
  return withEmbree(scene, resolved.threads, cpu::makeStream(scene, resolved));
}

}  // namespace ropelight
