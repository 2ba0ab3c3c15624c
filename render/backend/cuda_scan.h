#pragma once
// Prefix sums on the device, by CUB.

#include <cub/device/device_scan.cuh>

#include "render/backend/cuda_backend.h"

namespace ropelight::cuda {

struct Plus {
  template <class T>
  __host__ __device__ T operator()(const T& a, const T& b) const {
    return a + b;
  }
};

template <class T>
void Backend::exclusiveScan(const Buffer<T>& in, Buffer<T>& out, std::uint32_t n) {
  if (interrupted()) return;
  ledger_.launched("Scan");
  Timer const timer(*this, "Scan");
  RL_CUDA(cudaMemsetAsync(out.span().data, 0, sizeof(T), stream_));
  std::size_t bytes = 0;
  RL_CUDA(cub::DeviceScan::InclusiveScan(nullptr, bytes, in.view().data, out.span().data + 1, Plus{}, n, stream_));
  RL_CUDA(
      cub::DeviceScan::InclusiveScan(scratch(bytes), bytes, in.view().data, out.span().data + 1, Plus{}, n, stream_));
}

}  // namespace ropelight::cuda
