#include "render/backend/cuda_backend.h"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <cstdlib>

#include "render/backend/devices.h"

namespace ropelight::cuda {

Backend::Backend(const BackendChoice& choice) {
  RL_CUDA(cudaSetDevice(choice.gpu));
  for (const DeviceInfo& d : cudaDevices())
    if (d.index == choice.gpu) device_ = d;
  RL_CUDA(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking));
  int least = 0, greatest = 0;
  RL_CUDA(cudaDeviceGetStreamPriorityRange(&least, &greatest));
  RL_CUDA(cudaStreamCreateWithPriority(&copyStream_, cudaStreamNonBlocking, greatest));  // what is shown goes first
  RL_CUDA(cudaEventCreate(&before_));
  RL_CUDA(cudaEventCreate(&after_));
  timed_ = choice.stageTimes;
  totals_.allocate(*this, "counters", 1);
  next_.allocate(*this, "counters", 1);
  clearTallies();
}

Backend::~Backend() {
  cudaSetDevice(device_.index);
  cudaStreamSynchronize(stream_);
  cudaStreamDestroy(copyStream_);
  cudaEventDestroy(before_);
  cudaEventDestroy(after_);
  cudaStreamDestroy(stream_);
}

void Backend::sortPairs(Buffer<std::uint32_t>& keys, Buffer<std::uint32_t>& values, Buffer<std::uint32_t>& keyScratch,
                        Buffer<std::uint32_t>& valueScratch, std::uint32_t n, int bits) {
  if (n == 0 || interrupted()) return;
  ledger_.launched("Sort");
  Timer const timer(*this, "Sort");
  cub::DoubleBuffer<std::uint32_t> k(keys.span().data, keyScratch.span().data);
  cub::DoubleBuffer<std::uint32_t> v(values.span().data, valueScratch.span().data);
  std::size_t bytes = 0;
  RL_CUDA(cub::DeviceRadixSort::SortPairs(nullptr, bytes, k, v, n, 0, bits, stream_));
  RL_CUDA(cub::DeviceRadixSort::SortPairs(scratch(bytes), bytes, k, v, n, 0, bits, stream_));
  if (k.Current() != keys.span().data) keys.swap(keyScratch);
  if (v.Current() != values.span().data) values.swap(valueScratch);
}

void* Backend::scratch(std::size_t bytes) {
  if (scratch_.size() < bytes) {
    synchronize();
    scratch_.allocate(*this, "scan and sort", bytes + bytes / 4 + 256);
  }
  return scratch_.span().data;
}

cudaEvent_t Backend::mark() const {
  cudaEvent_t event;
  RL_CUDA(cudaEventCreate(&event));
  RL_CUDA(cudaEventRecord(event, stream_));
  return event;
}

double Backend::secondsSince(cudaEvent_t start) const {
  cudaEvent_t const stop = mark();
  RL_CUDA(cudaEventSynchronize(stop));
  float milliseconds = 0;
  RL_CUDA(cudaEventElapsedTime(&milliseconds, start, stop));
  cudaEventDestroy(start);
  cudaEventDestroy(stop);
  return milliseconds * 1e-3;
}

Backend::Timer::Timer(Backend& backend, const char* stage) : backend_(backend), stage_(stage) {
  if (backend_.timed_) cudaEventRecord(backend_.before_, backend_.stream_);
}

Backend::Timer::~Timer() {
  if (!backend_.timed_) return;
  cudaEventRecord(backend_.after_, backend_.stream_);
  cudaEventSynchronize(backend_.after_);
  float milliseconds = 0;
  cudaEventElapsedTime(&milliseconds, backend_.before_, backend_.after_);
  backend_.ledger_.timed(stage_, milliseconds * 1e-3);
}

}  // namespace ropelight::cuda
