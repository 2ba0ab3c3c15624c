#pragma once
// Pixels from a buffer into a texture, both on the GPU.

#include <optional>

#include "app/viewer/gl/gl.h"

namespace ropelight::view {

class Upload {
 public:
  /// Copies width·height RGBA in 32-bit floats, row by row from the texture's row 0. The buffer holds at least as many,
  /// the texture just as many.
  void operator()(const GlBuffer& buffer, const GlTexture& texture);

 private:
  bool computes(const GlBuffer& buffer);

  std::optional<GlProgram> program_;
};

}  // namespace ropelight::view
