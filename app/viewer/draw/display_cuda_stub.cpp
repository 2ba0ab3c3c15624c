#include "app/viewer/draw/display_cuda.h"

namespace ropelight::view {

std::unique_ptr<PixelPath> makeInteropPath(int gpu, std::string& why) {
  why = gpu < 0 ? "the film is in host memory (CPU backend)" : "this build has no CUDA";
  return nullptr;
}

}  // namespace ropelight::view
