#pragma once
// The numbers of one path: a pure function of (seed, stream, path, index, dimension).

#include "render/core/list.h"
#include "render/sampler/independent.h"
#include "render/sampler/sobol.h"

namespace ropelight::RL_TARGET {

using Samplers = List<SobolSampler, IndependentSampler>;

/// Separates paths from the camera and paths from the lights.
enum class Stream : std::uint32_t { camera = 0x243F6A88u, photon = 0x85A308D3u, caustic = 0x13198A2Eu };

/// A camera path is the pair (pixel, iteration): its scrambling belongs to the pixel and its index is the iteration.
/// A photon path is (block of 2³² photons, photon number): consecutive photons of all iterations share one sequence.
class Sampler {
 public:
  RL_HD Sampler(int kind, std::uint64_t seed, Stream stream, std::uint32_t path, std::uint32_t index)
      : independent_(kind == Samplers::indexOf<IndependentSampler>()),
        path_(path),
        index_(index),
        key0_(std::uint32_t(seed) ^ std::uint32_t(stream)),
        key1_(std::uint32_t(seed >> 32)),
        scramble_(hashCombine(hashCombine(key0_, key1_), path)) {}

  /// Two numbers in [0, 1) of the next dimension.
  RL_HD Vec2 next2() {
    std::uint32_t const d = dimension_++;
    if (independent_) return IndependentSampler::sample(index_, path_, d, key0_, key1_);
    return SobolSampler::sample(index_, hash32(scramble_ + d * 0x9E3779B9u));
  }

  /// One number of the next dimension.
  RL_HD Real next1() {
    if (independent_) return next2().x;
    return SobolSampler::sample1(index_, hash32(scramble_ + dimension_++ * 0x9E3779B9u));
  }

 private:
  bool independent_;
  std::uint32_t path_, index_, key0_, key1_;
  std::uint32_t scramble_;  ///< names the path's scramblings
  std::uint32_t dimension_ = 0;
};

}  // namespace ropelight::RL_TARGET
