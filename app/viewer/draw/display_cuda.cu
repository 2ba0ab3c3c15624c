#include "app/viewer/draw/display_cuda.h"

#include <cuda_runtime.h>
// After gl.h, since GLEW must come before any other GL header.
#include <cuda_gl_interop.h>

#include <algorithm>
#include <array>

namespace ropelight::view {
namespace {

/// The error in words; also clears it, so that a later check does not find it.
std::string words(const char* call, cudaError_t code) {
  (void)cudaGetLastError();
  return std::string(call) + ": " + cudaGetErrorString(code);
}

/// CUDA's registration of a GL buffer, until the buffer is deleted or changes its size.
class Registration {
 public:
  static std::shared_ptr<Registration> of(const GlBuffer& buffer, std::string& problem) {
    auto made = std::make_shared<Registration>();
    cudaError_t const code =
        cudaGraphicsGLRegisterBuffer(&made->resource_, buffer.name(), cudaGraphicsRegisterFlagsWriteDiscard);
    if (code == cudaSuccess) return made;
    problem = words("cudaGraphicsGLRegisterBuffer", code);
    return nullptr;
  }
  Registration() = default;
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;
  ~Registration() {
    if (resource_ && cudaGraphicsUnregisterResource(resource_) != cudaSuccess) (void)cudaGetLastError();
  }

  /// Null where it fails.
  void* map(std::size_t bytes, std::string& problem) {
    if (cudaError_t const code = cudaGraphicsMapResources(1, &resource_); code != cudaSuccess) {
      problem = words("cudaGraphicsMapResources", code);
      return nullptr;
    }
    cudaStreamSynchronize(nullptr);  // GL's reads come before this stream's work alone, and the copy has another one
    void* memory = nullptr;
    std::size_t size = 0;
    cudaError_t const code = cudaGraphicsResourceGetMappedPointer(&memory, &size, resource_);
    if (code == cudaSuccess && size >= bytes) return memory;
    problem = code == cudaSuccess ? std::to_string(size) + " bytes are mapped of " + std::to_string(bytes)
                                  : words("cudaGraphicsResourceGetMappedPointer", code);
    unmap();
    return nullptr;
  }
  bool unmap() { return cudaGraphicsUnmapResources(1, &resource_) == cudaSuccess; }

 private:
  cudaGraphicsResource_t resource_ = nullptr;
};

struct Unmapper {
  Registration& registration;
  bool done = false;
  bool unmap() {
    done = true;
    return registration.unmap();
  }
  ~Unmapper() {
    if (!done) (void)registration.unmap();
  }
};

class InteropPath final : public PixelPath {
 public:
  explicit InteropPath(int gpu) : gpu_(gpu) {}

  Filled fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write) override {
    if (cudaError_t const code = cudaSetDevice(gpu_); code != cudaSuccess) return fail(words("cudaSetDevice", code));
    if (!buffer.resize(bytes)) return fail("GL has no memory for a buffer of " + std::to_string(bytes) + " bytes");
    if (!buffer.attachment) buffer.attachment = Registration::of(buffer, problem_);
    auto* registration = static_cast<Registration*>(buffer.attachment.get());
    void* const memory = registration ? registration->map(bytes, problem_) : nullptr;
    if (!memory) return Filled::failed;
    Unmapper unmapper{*registration};
    bool const written = write(memory);
    if (!unmapper.unmap()) return fail(words("cudaGraphicsUnmapResources", cudaGetLastError()));
    return written ? Filled::done : Filled::nothing;
  }
  std::string describe() const override { return "interop: the GL context is on GPU " + std::to_string(gpu_); }
  const std::string& problem() const override { return problem_; }

 private:
  Filled fail(std::string problem) {
    problem_ = std::move(problem);
    return Filled::failed;
  }

  int gpu_;
  std::string problem_;
};

/// Whether the current GL context's frames are rendered by that GPU, else why it is not so.
bool contextIsOn(int gpu, std::string& why) {
  std::array<int, 16> devices{};
  unsigned count = 0;
  cudaError_t const code = cudaGLGetDevices(&count, devices.data(), unsigned(devices.size()), cudaGLDeviceListAll);
  auto const last = devices.begin() + std::min<std::size_t>(count, devices.size());
  if (code == cudaSuccess && std::find(devices.begin(), last, gpu) != last) return true;
  why = "the GL context is not on GPU " + std::to_string(gpu) + " (" +
        (code == cudaSuccess ? "cudaGLGetDevices names other GPUs" : words("cudaGLGetDevices", code)) + ")";
  return false;
}

}  // namespace

std::unique_ptr<PixelPath> makeInteropPath(int gpu, std::string& why) {
  if (gpu < 0) {
    why = "the film is in host memory (CPU backend)";
    return nullptr;
  }
  if (cudaError_t const code = cudaSetDevice(gpu); code != cudaSuccess) {
    why = words("cudaSetDevice", code);
    return nullptr;
  }
  // One registration now says more than the first frame would.
  auto path = std::make_unique<InteropPath>(gpu);
  GlBuffer probe;
  if (!contextIsOn(gpu, why)) return nullptr;
  if (path->fill(probe, 4096, [](void*) { return true; }) == Filled::done) return path;
  why = "GPU " + std::to_string(gpu) + " does not take GL's buffers (" + path->problem() + ")";
  return nullptr;
}

}  // namespace ropelight::view
