#pragma once
// A way for pixels and photons to get into a GL buffer.

#include <cstddef>
#include <functional>
#include <string>

#include "app/viewer/gl/gl.h"

namespace ropelight::view {

enum class Filled {
  done,     ///< the buffer holds what `write` wrote
  nothing,  ///< `write` had nothing to write; the buffer's contents are undefined
  failed,   ///< this path does not work here
};

class PixelPath {
 public:
  virtual ~PixelPath() = default;
  /// Makes the buffer hold `bytes` bytes and lets `write` fill them through a pointer to host memory or to that of the
  /// GPU; the pointer ends with the call. Where it fails, problem() says why.
  virtual Filled fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write) = 0;
  /// "interop: …" or "copy: …", with the reason.
  virtual std::string describe() const = 0;
  virtual const std::string& problem() const = 0;
};

}  // namespace ropelight::view
