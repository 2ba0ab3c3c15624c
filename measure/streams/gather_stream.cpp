#include "measure/streams/gather_stream.h"

#include "render/backend/cpu_backend.h"
// its driver, on that backend:
#include "measure/streams/gather_stream_impl.h"

namespace ropelight {

#if ROPELIGHT_CUDA
namespace cuda {
std::unique_ptr<GatherStream> makeGatherStream(const BackendChoice& choice);
}
#endif

std::unique_ptr<GatherStream> makeGatherStream(const BackendChoice& choice) {
  ChosenBackend const chosen = chooseBackend(choice);
  BackendChoice resolved = choice;
  resolved.gpu = chosen.gpu;
#if ROPELIGHT_CUDA
  if (chosen.cuda) return cuda::makeGatherStream(resolved);
#endif
  return std::make_unique<cpu::GatherStreamOn<cpu::Backend>>(resolved);
}

}  // namespace ropelight
