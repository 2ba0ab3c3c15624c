#pragma once
// The one window of the program and its OpenGL context.

#include <string>
#include <vector>

struct GLFWwindow;

namespace ropelight::view {

struct Size {
  int width = 0, height = 0;
  bool operator==(const Size&) const = default;
};

class Window {
 public:
  /// Opens a window of that size in screen coordinates, its context current: OpenGL 4.5 core, or 3.3 core where that is
  /// missing. Throws Error (noDevice) without a display or with an older GL, saying what was found.
  Window(const std::string& title, int width, int height, bool resizable = true);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  Size framebufferSize() const;  ///< pixels; 0 × 0 while minimised
  Size windowSize() const;       ///< screen coordinates, those of the mouse
  float contentScale() const;    ///< of its monitor: 1, 2 on HiDPI, or between
  bool minimised() const;

  bool shouldClose() const;
  void setTitle(const std::string& title);
  /// Asks the window manager; the result shows in windowSize() after later polls.
  void resize(int width, int height);
  void setVsync(bool on);

  /// Handles pending events; waits at most that long for the first one.
  void poll(double timeoutSeconds = 0);
  void swap();
  /// Files dropped on the window since the last call.
  std::vector<std::string> takeDroppedFiles();
  /// Keys that went down since the last call, with GLFW's modifiers: a short tap may be over before anyone looks.
  struct KeyTap {
    int key = 0, modifiers = 0;
  };
  std::vector<KeyTap> takeKeyTaps();
  /// Whether mouse, keys or the window itself did anything since the last call.
  bool takeActivity();

  const std::string& glVersion() const { return glVersion_; }    ///< GL_VERSION
  const std::string& glRenderer() const { return glRenderer_; }  ///< GL_RENDERER

 private:
  GLFWwindow* window_ = nullptr;
  std::vector<std::string> dropped_;
  std::vector<KeyTap> taps_;
  bool active_ = true;
  std::string title_, glVersion_, glRenderer_;
};

}  // namespace ropelight::view
