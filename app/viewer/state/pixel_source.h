#pragma once
// Where the display takes pixels and photons from: the renderer, or a test.

#include <cstddef>
#include <cstdint>

#include "render/integrators/integrator.h"

namespace ropelight::view {

class PixelSource {
 public:
  virtual ~PixelSource() = default;
  /// Copies the latest pixels of estimate `which`, RGBA floats from the top row: at most `capacity` bytes, to host
  /// memory or to the GPU's. False where nothing was copied; else width, height and iterations are set.
  virtual bool copyPixels(int which, void* to, std::size_t capacity, int& width, int& height,
                          std::uint64_t& iterations) = 0;
  /// Copies at most `capacity` photons to host memory or to the GPU's; returns the count copied.
  virtual std::uint32_t copyPhotons(int which, PhotonPoint* to, std::uint32_t capacity) = 0;
};

}  // namespace ropelight::view
