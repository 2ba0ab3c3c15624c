#include "app/viewer/gl/upload.h"

#include <cstddef>

namespace ropelight::view {

void Upload::operator()(const GlBuffer& buffer, const GlTexture& texture) {
  int const width = texture.width(), height = texture.height();
  if (computes(buffer)) {
    program_->use();
    program_->set("width", width);
    program_->set("height", height);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.name());
    glBindImageTexture(0, texture.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
    glDispatchCompute(GLuint(width + 15) / 16, GLuint(height + 15) / 16, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
    return;
  }
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer.name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, nullptr);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

/// Only what CUDA filled is in the GPU's own memory for certain, where shaders read it fast.
bool Upload::computes(const GlBuffer& buffer) {
  if (!buffer.attachment || !GLEW_VERSION_4_3) return false;
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (buffer.size() > std::size_t(most)) return false;
  if (!program_) program_.emplace("upload", true);
  return true;
}

}  // namespace ropelight::view
