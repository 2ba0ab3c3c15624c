#pragma once
// The CPU as a backend: oneTBB over all cores. Results never depend on how the work was divided.

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <memory>
#include <vector>

#include "render/backend/devices.h"
#include "render/backend/kernel_use.h"
#include "render/backend/ledger.h"
#include "render/backend/tally.h"
#include "render/core/radix_sort.h"
#include "render/core/span.h"

namespace ropelight::RL_TARGET {

class Backend {
 public:
  /// Items that one call of a stage should take where neighbours share work.
  static constexpr std::uint32_t batch = 1024;

  /// Memory of `size` elements under a purpose in the ledger; contents are undefined until written.
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
      data_.reset(new T[size]);
      ledger_ = &backend.ledger_;
      purpose_ = purpose;
      size_ = size;
      ledger_->allocated(purpose_, size_ * sizeof(T));
    }
    void release() {
      if (data_) ledger_->freed(purpose_, size_ * sizeof(T));
      data_.reset();
      size_ = 0;
    }
    void swap(Buffer& other) {
      std::swap(data_, other.data_);
      std::swap(size_, other.size_);
      std::swap(ledger_, other.ledger_);
      std::swap(purpose_, other.purpose_);
    }
    std::size_t size() const { return size_; }
    Span<T> span() const { return {data_.get(), std::uint32_t(size_)}; }
    Span<const T> view() const { return {data_.get(), std::uint32_t(size_)}; }

   private:
    std::unique_ptr<T[]> data_;
    std::size_t size_ = 0;
    Ledger* ledger_ = nullptr;
    const char* purpose_ = "";
  };

  explicit Backend(const BackendChoice& choice)
      : limit_(oneapi::tbb::global_control::max_allowed_parallelism,
               std::size_t(std::max(choice.threads, oneapi::tbb::info::default_concurrency()))),
        arena_(choice.threads > 0 ? choice.threads : oneapi::tbb::task_arena::automatic) {}

  Ledger& ledger() { return ledger_; }
  const Ledger& ledger() const { return ledger_; }
  int threads() const { return arena_.max_concurrency(); }
  DeviceInfo device() const;

  template <class T>
  void upload(Buffer<T>& to, const T* from, std::size_t count) {
    if (count > 0) std::memcpy(to.span().data, from, count * sizeof(T));
  }
  template <class T>
  void download(T* to, const Buffer<T>& from, std::size_t count, std::size_t first = 0) const {
    if (count > 0) std::memcpy(to, from.view().data + first, count * sizeof(T));
  }
  template <class T>
  void clear(Buffer<T>& buffer) {
    if (buffer.size() > 0) std::memset(static_cast<void*>(buffer.span().data), 0, buffer.size() * sizeof(T));
  }

  /// Calls stage(i, tally) for i in [0, n), in no order. The number is for a GPU alone.
  template <int = 0, class Stage>
  void forEach(std::uint32_t n, const Stage& stage) {
    if (interrupted()) return;
    auto const start = begin(Stage::name);
    arena_.execute([&] {
      using Range = oneapi::tbb::blocked_range<std::uint32_t>;
      oneapi::tbb::parallel_for(Range(0, n, Stage::grain), [&](const Range& range) {
        if (interrupted()) return;
        Tally tally;
        for (std::uint32_t i = range.begin(); i != range.end(); ++i) stage(i, tally);
        tallies_.local().add(tally);
      });
    });
    end(Stage::name, start);
  }

  template <int, class Stage>
  static KernelUse useOf() {
    return {Stage::name};
  }

  /// Calls stage(i, shared, tally); a CPU's caches need no copy of stage.shared.
  template <class Stage>
  void forEachShared(std::uint32_t n, const Stage& stage) {
    forEach(n, Shared<Stage>{stage});
  }

  /// Runs a stage element by element: stage.begin(i, lane), then stage.step(lane, stack) as long as it returns true.
  template <class Stage>
  void forEachRefilled(std::uint32_t n, const Stage& stage) {
    forEach(n, Refilled<Stage>{stage});
  }

  /// out[i] = in[0] + … + in[i−1]; the sum of all goes to out[n].
  template <class T>
  void exclusiveScan(const Buffer<T>& in, Buffer<T>& out, std::uint32_t n) {
    if (interrupted()) return;
    auto const start = begin("Scan");
    T sum{};
    const T* from = in.view().data;
    T* to = out.span().data;
    for (std::uint32_t i = 0; i < n; ++i) {
      T const value = from[i];
      to[i] = sum;
      sum = sum + value;
    }
    to[n] = sum;
    end("Scan", start);
  }

  /// Sorts pairs by the low `bits` of their keys, stable. keys and values hold the result; the others are scratch, of
  /// the same size, and may trade places with them.
  void sortPairs(Buffer<std::uint32_t>& keys, Buffer<std::uint32_t>& values, Buffer<std::uint32_t>& keyScratch,
                 Buffer<std::uint32_t>& valueScratch, std::uint32_t n, int bits) {
    if (interrupted()) return;
    auto const start = begin("Sort");
    bool traded = false;
    arena_.execute([&] {
      traded = radixSortPairsAside(keys.span().data, values.span().data, keyScratch.span().data,
                                   valueScratch.span().data, n, bits, threads());
    });
    if (traded) {
      keys.swap(keyScratch);
      values.swap(valueScratch);
    }
    end("Sort", start);
  }

  /// Wall-clock seconds of `work`.
  template <class Work>
  double timed(Work&& work) {
    auto const start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  void synchronize() {}
  void activate() const {}
  void timeStages(bool) {}  // always measured
  int gpu() const { return -1; }

  /// From any thread: stages do nothing from now on, the running one included, until resume().
  void interrupt() { interrupted_ = true; }
  bool interrupted() const { return interrupted_.load(std::memory_order_relaxed); }
  void resume() { interrupted_ = false; }

  /// For another thread than the one that runs stages; waits until the copy is done.
  template <class T>
  void copyOut(void* to, const Buffer<T>& from, std::size_t count) const {
    if (count > 0) std::memcpy(to, from.view().data, count * sizeof(T));
  }

  TallyTotals tallies() const {
    TallyTotals sum;
    for (const TallyTotals& t : tallies_) sum.add(t);
    return sum;
  }
  void clearTallies() { tallies_.clear(); }

 private:
  template <class Stage>
  struct Shared {
    static constexpr const char* name = Stage::name;
    static constexpr std::uint32_t grain = Stage::grain;
    const Stage& stage;

    void operator()(std::uint32_t i, Tally& tally) const { stage(i, stage.shared.data, tally); }
  };

  template <class Stage>
  struct Refilled {
    static constexpr const char* name = Stage::name;
    static constexpr std::uint32_t grain = Stage::grain;
    const Stage& stage;

    void operator()(std::uint32_t i, Tally&) const {
      typename Stage::Lane lane;
      typename Stage::Stack stack;
      stage.begin(i, lane);
      while (stage.step(lane, stack)) {
      }
    }
  };

  using Clock = std::chrono::steady_clock;

  Clock::time_point begin(const char* stage) {
    ledger_.launched(stage);
    return Clock::now();
  }
  void end(const char* stage, Clock::time_point start) {
    ledger_.timed(stage, std::chrono::duration<double>(Clock::now() - start).count());
  }

  Ledger ledger_;
  std::atomic<bool> interrupted_ = false;
  oneapi::tbb::global_control limit_;  // lets the arena have more threads than there are cores
  oneapi::tbb::task_arena arena_;
  oneapi::tbb::enumerable_thread_specific<TallyTotals> tallies_;
};

}  // namespace ropelight::RL_TARGET
