#pragma once
// The one place that knows which compiler reads a header: host/device markers, the target namespace, the scalar.

#include <cstdint>

#if defined(__CUDACC__)
#define RL_HD __host__ __device__
#define RL_TARGET cuda
#define RL_CUDA_TARGET 1
#elif defined(ROPELIGHT_TEST_TARGET)  // a test's own copy of the kernels, with lists that it has added to
#define RL_HD
#define RL_TARGET ROPELIGHT_TEST_TARGET
#define RL_CUDA_TARGET 0
#elif defined(ROPELIGHT_DOUBLE)
#define RL_HD
#define RL_TARGET cpu64
#define RL_CUDA_TARGET 0
#else
#define RL_HD
#define RL_TARGET cpu
#define RL_CUDA_TARGET 0
#endif

#if defined(__CUDA_ARCH__)
#define RL_DEVICE_CODE 1
#else
#define RL_DEVICE_CODE 0
#endif

namespace ropelight {

/// Faults that a test puts into a copy of the kernels of its own (tests/stress), to see that the catalogue of hostile
/// cases finds them. Everywhere else faulty() is false at compile time and nothing is left of it.
enum class Fault {
  none,
  roulette,         ///< a constant cap on survival: infinite variance near albedo 1
  depthLimit,       ///< paths end after 256 edges
  rayOrigin,        ///< rays start on the surface that they leave
  segmentEnd,       ///< shadow rays too
  reflectance,      ///< Schlick's approximation for Fresnel's formula
  totalReflection,  ///< no total internal reflection
  otherSide,        ///< photons count on both sides of a wall
  discHeight,       ///< discs are cylinders without ends
  chunkNumbers,     ///< every pass of an iteration traces the same photons
  wholeDisc,        ///< discs are not cut at the edges of what they lie on
  foreignRows,      ///< photons of colliding rows of the grid are not told apart
  lampCone,         ///< 1 − cos of a lamp's cone as written, which cancels where the lamp is small
};

}  // namespace ropelight

namespace ropelight::RL_TARGET {

#if defined(RL_FAULTS)
extern Fault presentFault;
inline bool faulty(Fault fault) { return presentFault == fault; }
#else
RL_HD constexpr bool faulty(Fault) { return false; }
#endif

#if defined(ROPELIGHT_DOUBLE) && !defined(__CUDACC__)
using Real = double;
#else
using Real = float;
#endif

// A product that no compiler may fuse into a multiply-add: edge tests rely on fl(ab) − fl(cd) being antisymmetric.
RL_HD inline Real mulRounded(Real a, Real b) {
#if RL_DEVICE_CODE
  return __fmul_rn(a, b);
#else
  return a * b;  // host code is built with -ffp-contract=off
#endif
}

// a·b + c, contracted on the device and never on the host: the same function of its arguments wherever it is inlined.
RL_HD inline Real mulAdd(Real a, Real b, Real c) {
#if RL_DEVICE_CODE
  return __fmaf_rn(a, b, c);
#else
  return a * b + c;
#endif
}

RL_HD inline std::uint32_t reverseBits(std::uint32_t x) {
#if RL_DEVICE_CODE
  return __brev(x);
#else
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
  return __builtin_bswap32(x);
#endif
}

RL_HD inline std::uint32_t mulHigh(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
}

}  // namespace ropelight::RL_TARGET
