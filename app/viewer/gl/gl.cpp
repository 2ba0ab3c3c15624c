#include "app/viewer/gl/gl.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "render/core/error.h"

namespace ropelight::view {
namespace {

namespace fs = std::filesystem;

template <class Create>
GLuint created(Create create) {
  GLuint name = 0;
  create(1, &name);
  return name;
}

/// The log of a shader or of a program, by its pair of GL functions.
template <class GetValue, class GetLog>
std::string logOf(GLuint name, GetValue getValue, GetLog getLog) {
  GLint length = 0;
  getValue(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length > 0 ? length : 1), '\0');
  getLog(name, GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  return log;
}

std::string readShader(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    throw Error(fmt::format("{}: the shader cannot be read; install the program again", file.string()),
                ExitCode::internal);
  return text.str();
}

/// A shader in a program, until it is linked.
class Shader {
 public:
  Shader(GLuint program, GLenum kind, const fs::path& file) : program_(program), name_(glCreateShader(kind)) {
    glAttachShader(program_, name_);
    compile(file);
  }
  ~Shader() {
    glDetachShader(program_, name_);
    glDeleteShader(name_);
  }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

 private:
  void compile(const fs::path& file) const {
    std::string const text = readShader(file);
    const char* source = text.c_str();
    glShaderSource(name_, 1, &source, nullptr);
    glCompileShader(name_);
    GLint done = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &done);
    if (done != GL_TRUE)
      throw Error(
          fmt::format("{}: does not compile: {}", file.string(), logOf(name_, glGetShaderiv, glGetShaderInfoLog)),
          ExitCode::internal);
  }

  GLuint program_, name_;
};

void link(GLuint program, const fs::path& file) {
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done != GL_TRUE)
    throw Error(fmt::format("{}: the shaders do not link: {}", file.string(),
                            logOf(program, glGetProgramiv, glGetProgramInfoLog)),
                ExitCode::internal);
}

}  // namespace

void releaseBuffer(GLuint name) {
  if (name) glDeleteBuffers(1, &name);
}
void releaseTexture(GLuint name) {
  if (name) glDeleteTextures(1, &name);
}
void releaseVertexArray(GLuint name) {
  if (name) glDeleteVertexArrays(1, &name);
}
void releaseFramebuffer(GLuint name) {
  if (name) glDeleteFramebuffers(1, &name);
}
void releaseProgram(GLuint name) {
  if (name) glDeleteProgram(name);
}

GlBuffer::GlBuffer() : name_(created(glGenBuffers)) {}

GlBuffer& GlBuffer::operator=(GlBuffer&& other) noexcept {
  attachment = std::move(other.attachment);
  name_ = std::move(other.name_);
  std::swap(size_, other.size_);
  return *this;
}

bool GlBuffer::resize(std::size_t bytes, GLenum usage) {
  if (bytes == size_) return true;
  attachment.reset();
  clearGlErrors();
  glBindBuffer(GL_COPY_WRITE_BUFFER, name());
  glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(bytes), nullptr, usage);
  bool const failed = clearGlErrors();
  if (failed) glBufferData(GL_COPY_WRITE_BUFFER, 0, nullptr, usage);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  size_ = failed ? 0 : bytes;
  return !failed;
}

GlTexture::GlTexture() : name_(created(glGenTextures)) {
  glBindTexture(GL_TEXTURE_2D, name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool GlTexture::resize(int width, int height, GLenum format) {
  if (width == width_ && height == height_) return true;
  clearGlErrors();
  glBindTexture(GL_TEXTURE_2D, name());
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  bool const failed = clearGlErrors();
  if (failed) glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), 0, 0, 0, GL_RGBA, GL_FLOAT, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  width_ = failed ? 0 : width;
  height_ = failed ? 0 : height;
  return !failed;
}

GlVertexArray::GlVertexArray() : GlName(created(glGenVertexArrays)) {}
GlFramebuffer::GlFramebuffer() : GlName(created(glGenFramebuffers)) {}

GlProgram::GlProgram(const std::string& name, bool compute) : name_(glCreateProgram()) {
  std::string const path = (shadersFolder() / name).string();
  if (compute) {
    Shader const shader(name_.name(), GL_COMPUTE_SHADER, path + ".comp");
    link(name_.name(), path);
  } else {
    Shader const vertex(name_.name(), GL_VERTEX_SHADER, path + ".vert");
    Shader const fragment(name_.name(), GL_FRAGMENT_SHADER, path + ".frag");
    link(name_.name(), path);
  }
}

void GlProgram::use() const { glUseProgram(name_.name()); }

GLint GlProgram::location(const char* uniform) {
  auto found = locations_.find(uniform);
  if (found == locations_.end()) found = locations_.emplace(uniform, glGetUniformLocation(name_.name(), uniform)).first;
  return found->second;
}

void GlProgram::set(const char* uniform, int value) { glUniform1i(location(uniform), value); }
void GlProgram::set(const char* uniform, float value) { glUniform1f(location(uniform), value); }
void GlProgram::set(const char* uniform, std::array<float, 2> v) { glUniform2fv(location(uniform), 1, v.data()); }
void GlProgram::set(const char* uniform, std::array<float, 3> v) { glUniform3fv(location(uniform), 1, v.data()); }
void GlProgram::set(const char* uniform, std::array<float, 4> v) { glUniform4fv(location(uniform), 1, v.data()); }
void GlProgram::set(const char* uniform, std::span<const std::array<float, 3>> values) {
  glUniform3fv(location(uniform), GLsizei(values.size()), values.front().data());
}

fs::path shadersFolder() {
  std::error_code failed;
  fs::path const program = fs::read_symlink("/proc/self/exe", failed);
  fs::path const installed = program.parent_path().parent_path() / "share" / "ropelight" / "shaders";
  if (!failed && fs::is_directory(installed, failed)) return installed;
  return ROPELIGHT_SHADERS;
}

int maxTextureSize() {
  GLint size = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
  return size;
}

bool clearGlErrors() {
  bool outOfMemory = false;
  for (int i = 0; i < 64; ++i) {  // a lost context may give errors without end
    GLenum const error = glGetError();
    if (error == GL_NO_ERROR) break;
    outOfMemory |= error == GL_OUT_OF_MEMORY;
  }
  return outOfMemory;
}

}  // namespace ropelight::view
