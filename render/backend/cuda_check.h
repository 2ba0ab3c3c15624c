#pragma once
// CUDA calls that cannot fail unless we did something wrong, and allocations that may.

#include <cuda_runtime.h>

#include <new>
#include <string>

#include "render/core/error.h"

namespace ropelight::cuda {

inline void check(cudaError_t code, const char* expression) {
  if (code == cudaSuccess) return;
  throw Error(std::string("CUDA: ") + expression + " gave " + cudaGetErrorName(code) + ": " + cudaGetErrorString(code),
              ExitCode::internal);
}

}  // namespace ropelight::cuda

#define RL_CUDA(expression) ::ropelight::cuda::check((expression), #expression)
