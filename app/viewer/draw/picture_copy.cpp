#include "app/viewer/draw/picture_copy.h"

#include <fmt/format.h>

namespace ropelight::view {
namespace {

/// A buffer's memory as long as this lives; null where it cannot be mapped.
class Mapping {
 public:
  Mapping(const GlBuffer& buffer, std::size_t bytes) {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer.name());
    memory_ =
        glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, GLsizeiptr(bytes), GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  }
  ~Mapping() { unmap(); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  void* memory() const { return memory_; }
  /// False where GL lost the contents, as it may when a screen changes its mode.
  bool unmap() {
    bool const kept = !memory_ || glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER) == GL_TRUE;
    memory_ = nullptr;
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    return kept;
  }

 private:
  void* memory_ = nullptr;
};

}  // namespace

Filled CopyPath::fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write) {
  buffer.attachment.reset();
  if (!buffer.resize(bytes)) {
    problem_ = fmt::format("GL has no memory for a buffer of {} bytes", bytes);
    return Filled::failed;
  }
  Mapping mapping(buffer, bytes);
  if (!mapping.memory()) {
    clearGlErrors();
    problem_ = fmt::format("GL does not map a buffer of {} bytes", bytes);
    return Filled::failed;
  }
  bool const written = write(mapping.memory());
  return mapping.unmap() && written ? Filled::done : Filled::nothing;
}

}  // namespace ropelight::view
