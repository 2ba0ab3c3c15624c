#pragma once
// The path without a copy through host memory: the GL buffer mapped into the memory of the GPU that renders.

#include <memory>
#include <string>

#include "app/viewer/draw/pixel_path.h"

namespace ropelight::view {

/// Null, and `why` in words, where buffers cannot be shared: gpu −1 (the film is in host memory), a current GL context
/// that is not on that GPU, a build without CUDA.
std::unique_ptr<PixelPath> makeInteropPath(int gpu, std::string& why);

}  // namespace ropelight::view
