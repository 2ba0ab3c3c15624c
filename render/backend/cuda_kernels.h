#pragma once
// The kernels that run stages: one thread an element, with shared memory, or with warps that fetch new work.

#include <type_traits>

#include "render/backend/cuda_check.h"
#include "render/backend/tally.h"
#include "render/core/span.h"

namespace ropelight::cuda {

/// Sum over a full warp, valid in lane 0.
__device__ inline std::uint32_t warpSum(std::uint32_t value) {
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
  return __reduce_add_sync(0xFFFFFFFFu, value);
#else
  for (int step = 16; step > 0; step /= 2) value += __shfl_down_sync(0xFFFFFFFFu, value, step);
  return value;
#endif
}

__device__ inline void addToTotals(TallyTotals* totals, const Tally& t) {
  auto const add = [](unsigned long long* to, std::uint32_t value) {
    std::uint32_t const sum = warpSum(value);
    if ((threadIdx.x & 31) == 0 && sum != 0) atomicAdd(to, static_cast<unsigned long long>(sum));
  };
  add(&totals->rays, t.rays);
  add(&totals->shadowRays, t.shadowRays);
  if (!__any_sync(0xFFFFFFFFu, t.nonFinite | t.truncated | t.nonFinitePaths | t.nonFinitePhotons)) return;  // the rule
  add(&totals->nonFinite, t.nonFinite);
  add(&totals->truncated, t.truncated);
  add(&totals->nonFinitePaths, t.nonFinitePaths);
  add(&totals->nonFinitePhotons, t.nonFinitePhotons);
}

inline constexpr int stageThreads = 128;  ///< of a block

/// What every kernel of a stage does.
template <class Stage>
__device__ inline void callStage(std::uint32_t n, const Stage& stage, TallyTotals* totals) {
  std::uint32_t const i = blockIdx.x * blockDim.x + threadIdx.x;
  Tally tally;
  if (i < n) stage(i, tally);
  addToTotals(totals, tally);
}

template <class Stage>
__global__ void runStage(std::uint32_t n, const __grid_constant__ Stage stage, TallyTotals* totals) {
  callStage(n, stage, totals);
}

/// The same with a bound on registers: blocks that a multiprocessor must hold at once.
template <class Stage, int blocks>
__global__ void __launch_bounds__(stageThreads, blocks)
    runBounded(std::uint32_t n, const __grid_constant__ Stage stage, TallyTotals* totals) {
  callStage(n, stage, totals);
}

/// The kernel of a stage. blocks: as in runBounded; 0: no bound, which leaves the compiler its own balance.
template <class Stage, int blocks>
constexpr auto kernelOf() {
  if constexpr (blocks > 0)
    return &runBounded<Stage, blocks>;
  else
    return &runStage<Stage>;
}

/// As runStage, with what stage.shared spans copied into shared memory first.
template <class Stage>
__global__ void runShared(std::uint32_t n, Stage stage, TallyTotals* totals) {
  using Element = std::remove_const_t<std::remove_pointer_t<decltype(stage.shared.data)>>;
  extern __shared__ __align__(16) unsigned char sharedBytes[];
  Element* const shared = reinterpret_cast<Element*>(sharedBytes);
  for (std::uint32_t k = threadIdx.x; k < stage.shared.size; k += blockDim.x) shared[k] = stage.shared[k];
  __syncthreads();
  Tally tally;
  std::uint32_t const stride = gridDim.x * blockDim.x;
  for (std::uint32_t i = blockIdx.x * blockDim.x + threadIdx.x; i < n; i += stride) stage(i, shared, tally);
  addToTotals(totals, tally);
}

/// Below so many busy lanes a warp fetches new work (Aila & Laine 2009, "Understanding the Efficiency of Ray Traversal
/// on GPUs").
inline constexpr int refillBelow = 24;

/// Warps that live until all work is done: whenever too many lanes are idle, those take the next elements.
template <class Stage>
__global__ void __launch_bounds__(128) runRefilled(std::uint32_t n, Stage stage, std::uint32_t* next) {
  typename Stage::Lane lane;
  typename Stage::Stack stack;
  bool busy = false, exhausted = false;
  for (;;) {
    unsigned const idle = __ballot_sync(0xFFFFFFFFu, !busy);
    if (!exhausted && __popc(idle) > 32 - refillBelow) {
      std::uint32_t first = 0;
      if ((threadIdx.x & 31) == 0) first = atomicAdd(next, std::uint32_t(__popc(idle)));
      first = __shfl_sync(0xFFFFFFFFu, first, 0);
      exhausted = first + std::uint32_t(__popc(idle)) >= n;
      std::uint32_t const i = first + std::uint32_t(__popc(idle & ((1u << (threadIdx.x & 31)) - 1)));
      if (!busy && i < n) {
        stage.begin(i, lane);
        busy = true;
      }
    } else if (idle == 0xFFFFFFFFu) {
      return;
    }
    if (busy) busy = stage.step(lane, stack);
    __syncwarp();
  }
}

}  // namespace ropelight::cuda
