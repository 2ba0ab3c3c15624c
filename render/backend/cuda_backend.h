#pragma once
// A CUDA device as a backend: one stream, one thread an element, CUB for scans and sorts.

#include <algorithm>
#include <atomic>
#include <type_traits>
#include <utility>

#include "render/backend/cuda_check.h"
#include "render/backend/cuda_kernels.h"
#include "render/backend/devices.h"
#include "render/backend/kernel_use.h"
#include "render/backend/ledger.h"
#include "render/backend/tally.h"
#include "render/core/span.h"

namespace ropelight::cuda {

class Backend {
 public:
  /// Items that one call of a stage should take where neighbours share work.
  static constexpr std::uint32_t batch = 4;

  /// Device memory of `size` elements under a purpose in the ledger; contents are undefined until written.
  template <class T>
  class Buffer {
   public:
    Buffer() = default;
    Buffer(Backend& backend, const char* purpose, std::size_t size) { allocate(backend, purpose, size); }
    ~Buffer() { release(); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    /// Throws std::bad_alloc and keeps nothing where the memory cannot be had.
    void allocate(Backend& backend, const char* purpose, std::size_t size) {
      if (size == size_) return;
      release();
      if (size == 0) return;
      if (cudaMalloc(&data_, size * sizeof(T)) != cudaSuccess) {
        cudaGetLastError();  // the failure is answered here and must not show up in the next check
        data_ = nullptr;
        throw std::bad_alloc();
      }
      ledger_ = &backend.ledger_;
      purpose_ = purpose;
      size_ = size;
      ledger_->allocated(purpose_, size_ * sizeof(T));
    }
    void release() {
      if (!data_) return;
      cudaFree(data_);
      ledger_->freed(purpose_, size_ * sizeof(T));
      data_ = nullptr;
      size_ = 0;
    }
    void swap(Buffer& other) {
      std::swap(data_, other.data_);
      std::swap(size_, other.size_);
      std::swap(ledger_, other.ledger_);
      std::swap(purpose_, other.purpose_);
    }
    std::size_t size() const { return size_; }
    Span<T> span() const { return {data_, std::uint32_t(size_)}; }
    Span<const T> view() const { return {data_, std::uint32_t(size_)}; }

   private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
    Ledger* ledger_ = nullptr;
    const char* purpose_ = "";
  };

  explicit Backend(const BackendChoice& choice);
  ~Backend();
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;

  Ledger& ledger() { return ledger_; }
  const Ledger& ledger() const { return ledger_; }
  const DeviceInfo& device() const { return device_; }

  template <class T>
  void upload(Buffer<T>& to, const T* from, std::size_t count) {
    if (count == 0) return;
    RL_CUDA(cudaMemcpyAsync(to.span().data, from, count * sizeof(T), cudaMemcpyHostToDevice, stream_));
    synchronize();
  }
  template <class T>
  void download(T* to, const Buffer<T>& from, std::size_t count, std::size_t first = 0) const {
    if (count == 0) return;
    RL_CUDA(cudaMemcpyAsync(to, from.view().data + first, count * sizeof(T), cudaMemcpyDeviceToHost, stream_));
    synchronize();
  }
  template <class T>
  void clear(Buffer<T>& buffer) {
    if (buffer.size() > 0) RL_CUDA(cudaMemsetAsync(buffer.span().data, 0, buffer.size() * sizeof(T), stream_));
  }

  /// Calls stage(i, tally) for i in [0, n), in no order. blocks: see kernelOf.
  template <int blocks = 0, class Stage>
  void forEach(std::uint32_t n, const Stage& stage) {
    if (n == 0 || interrupted()) return;
    ledger_.launched(Stage::name);
    constexpr std::uint32_t threads = stageThreads;
    Timer const timer(*this, Stage::name);
    kernelOf<Stage, blocks>()<<<(n + threads - 1) / threads, threads, 0, stream_>>>(n, stage, totals_.span().data);
    RL_CUDA(cudaGetLastError());
  }

  template <int blocks, class Stage>
  static KernelUse useOf() {
    cudaFuncAttributes a{};
    auto const kernel = kernelOf<Stage, blocks>();
    RL_CUDA(cudaFuncGetAttributes(&a, kernel));
    return {Stage::name, "", a.numRegs, a.localSizeBytes, a.binaryVersion};
  }

  /// Calls stage(i, shared, tally), where shared points to a copy of stage.shared in shared memory.
  template <class Stage>
  void forEachShared(std::uint32_t n, const Stage& stage) {
    if (n == 0 || interrupted()) return;
    ledger_.launched(Stage::name);
    constexpr int threads = 128;
    std::size_t const bytes = stage.shared.size * sizeof(*stage.shared.data);
    int const all = int((std::uint64_t(n) + threads - 1) / threads);
    int const blocks = std::min(all, residentBlocks(runShared<Stage>, threads, bytes));
    Timer const timer(*this, Stage::name);
    runShared<<<blocks, threads, bytes, stream_>>>(n, stage, totals_.span().data);
    RL_CUDA(cudaGetLastError());
  }

  /// Runs a stage whose elements take steps of uneven number: stage.begin(i, lane), then stage.step(lane, stack) as
  /// long as it returns true.
  template <class Stage>
  void forEachRefilled(std::uint32_t n, const Stage& stage) {
    if (n == 0 || interrupted()) return;
    ledger_.launched(Stage::name);
    int const blocks = residentBlocks(runRefilled<Stage>, 128, 0);
    RL_CUDA(cudaMemsetAsync(next_.span().data, 0, sizeof(std::uint32_t), stream_));
    Timer const timer(*this, Stage::name);
    runRefilled<<<blocks, 128, 0, stream_>>>(n, stage, next_.span().data);
    RL_CUDA(cudaGetLastError());
  }

  /// out[i] = in[0] + … + in[i−1]; the sum of all goes to out[n]. `in` has room for n elements, out for n + 1. Defined
  /// in cuda_scan.h, which few units need.
  template <class T>
  void exclusiveScan(const Buffer<T>& in, Buffer<T>& out, std::uint32_t n);

  /// Sorts pairs by the low `bits` of their keys, stable. keys and values hold the result; the others are scratch, of
  /// the same size, and may trade places with them.
  void sortPairs(Buffer<std::uint32_t>& keys, Buffer<std::uint32_t>& values, Buffer<std::uint32_t>& keyScratch,
                 Buffer<std::uint32_t>& valueScratch, std::uint32_t n, int bits);

  /// Device seconds from the first stage that `work` queues to the end of the last.
  template <class Work>
  double timed(Work&& work) {
    cudaEvent_t const start = mark();
    work();
    return secondsSince(start);
  }

  void synchronize() const { RL_CUDA(cudaStreamSynchronize(stream_)); }

  /// Makes this device the calling thread's.
  void activate() const { RL_CUDA(cudaSetDevice(device_.index)); }
  void timeStages(bool on) { timed_ = on; }
  int gpu() const { return device_.index; }

  /// From any thread: no stage is launched from now on until resume().
  void interrupt() { interrupted_ = true; }
  bool interrupted() const { return interrupted_.load(std::memory_order_relaxed); }
  void resume() { interrupted_ = false; }

  /// For another thread than the one that launches stages, to host or device memory; waits until the copy is done.
  template <class T>
  void copyOut(void* to, const Buffer<T>& from, std::size_t count) const {
    activate();
    if (count == 0) return;
    RL_CUDA(cudaMemcpyAsync(to, from.view().data, count * sizeof(T), cudaMemcpyDefault, copyStream_));
    RL_CUDA(cudaStreamSynchronize(copyStream_));
  }

  TallyTotals tallies() const {
    TallyTotals t;
    download(&t, totals_, 1);
    return t;
  }
  void clearTallies() { clear(totals_); }

 private:
  /// Adds a stage's device time to the ledger where timing was asked for; costs a synchronisation then.
  class Timer {
   public:
    Timer(Backend& backend, const char* stage);
    ~Timer();
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    Backend& backend_;
    const char* stage_;
  };

  void* scratch(std::size_t bytes);
  cudaEvent_t mark() const;
  double secondsSince(cudaEvent_t start) const;

  /// Blocks that fill the device.
  template <class Kernel>
  int residentBlocks(Kernel* kernel, int threads, std::size_t sharedBytes) const {
    int each = 0, processors = 0;
    RL_CUDA(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, kernel, threads, sharedBytes));
    RL_CUDA(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device_.index));
    return std::max(1, each) * processors;
  }

  Ledger ledger_;
  DeviceInfo device_;
  cudaStream_t stream_ = nullptr, copyStream_ = nullptr;
  cudaEvent_t before_ = nullptr, after_ = nullptr;
  bool timed_ = false;
  std::atomic<bool> interrupted_ = false;
  Buffer<TallyTotals> totals_;
  Buffer<std::uint32_t> next_;  ///< element that a warp takes next
  Buffer<unsigned char> scratch_;
};

}  // namespace ropelight::cuda
