#pragma once
// OpenGL names that delete themselves, and programs from shaders/. A context must be current wherever these are used.

#include <GL/glew.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace ropelight::view {

void releaseBuffer(GLuint name);
void releaseTexture(GLuint name);
void releaseVertexArray(GLuint name);
void releaseFramebuffer(GLuint name);
void releaseProgram(GLuint name);

/// One GL object; 0: none.
template <auto Release>
class GlName {
 public:
  explicit GlName(GLuint name = 0) : name_(name) {}
  ~GlName() { Release(name_); }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

/// A buffer object. What another API keeps for it (a CUDA registration) is attached to it, and is released before its
/// memory.
class GlBuffer {
 public:
  GlBuffer();
  ~GlBuffer() { attachment.reset(); }
  GlBuffer(GlBuffer&&) = default;
  GlBuffer& operator=(GlBuffer&& other) noexcept;

  GLuint name() const { return name_.name(); }
  std::size_t size() const { return size_; }  ///< bytes
  /// Holds `bytes` bytes, undefined after a change of size. False where GL has no memory for it; its size is then 0.
  bool resize(std::size_t bytes, GLenum usage = GL_STREAM_DRAW);

  std::shared_ptr<void> attachment;

 private:
  GlName<releaseBuffer> name_;
  std::size_t size_ = 0;
};

/// A 2D texture of RGBA in 32-bit floats, one level of them, clamped at its edges.
class GlTexture {
 public:
  GlTexture();
  GLuint name() const { return name_.name(); }
  int width() const { return width_; }
  int height() const { return height_; }
  /// False where GL has no memory for it; it is then empty.
  bool resize(int width, int height, GLenum format = GL_RGBA32F);

 private:
  GlName<releaseTexture> name_;
  int width_ = 0, height_ = 0;
};

class GlVertexArray : public GlName<releaseVertexArray> {
 public:
  GlVertexArray();
};

class GlFramebuffer : public GlName<releaseFramebuffer> {
 public:
  GlFramebuffer();
};

/// A program of shaders. Setting a uniform that it does not use does nothing.
class GlProgram {
 public:
  /// From shadersFolder()/NAME.vert and NAME.frag, or from NAME.comp. Throws Error (internal) with the file and GL's
  /// log.
  explicit GlProgram(const std::string& name, bool compute = false);

  /// Makes it current; the setters need that.
  void use() const;
  void set(const char* uniform, int value);
  void set(const char* uniform, float value);
  void set(const char* uniform, std::array<float, 2> value);
  void set(const char* uniform, std::array<float, 3> value);
  void set(const char* uniform, std::array<float, 4> value);
  void set(const char* uniform, std::span<const std::array<float, 3>> values);

 private:
  GLint location(const char* uniform);

  GlName<releaseProgram> name_;
  std::map<std::string, GLint, std::less<>> locations_;
};

/// The folder of the GLSL files: beside an installed program, else in the source tree.
std::filesystem::path shadersFolder();

/// Largest width or height of a texture, pixels.
int maxTextureSize();

/// Reads GL's errors until there is none; whether one of them was GL_OUT_OF_MEMORY.
bool clearGlErrors();

}  // namespace ropelight::view
