#include "app/viewer/gl/window.h"

// GLEW first: it must come before any other GL header.
#include "app/viewer/gl/gl.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/core/error.h"

namespace ropelight::view {
namespace {

Window& windowOf(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

constexpr const char* remedy = "render to a file instead: ropelight render SCENE -o out.png";

std::string& latestProblem() {
  static std::string problem;
  return problem;
}

void onError(int, const char* description) {
  std::string problem = description ? description : "";
  std::replace(problem.begin(), problem.end(), '\n', ' ');
  latestProblem() = problem;
}

std::string glText(GLenum name) {
  auto const* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

GLFWwindow* open(const std::string& title, int width, int height, bool resizable, int major, int minor) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
  glfwWindowHint(GLFW_OPENGL_PROFILE, major >= 3 ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_ANY_PROFILE);
  glfwWindowHint(GLFW_RESIZABLE, resizable ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_VISIBLE, major >= 3 ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

/// What is available where neither required version is: the version of a default context, or why there is none.
std::string foundInstead() {
  std::string const problem = latestProblem();
  GLFWwindow* const window = open("", 16, 16, false, 1, 0);
  if (!window) return fmt::format("no OpenGL context can be made ({})", problem);
  glfwMakeContextCurrent(window);
  // GLEW is not up yet, so the function is asked for by its name.
  auto const getString = reinterpret_cast<const GLubyte*(GLAPIENTRY*)(GLenum)>(glfwGetProcAddress("glGetString"));
  auto const* version = getString ? reinterpret_cast<const char*>(getString(GL_VERSION)) : nullptr;
  std::string const found = fmt::format("this display has OpenGL {}", version ? version : "of an unknown version");
  glfwDestroyWindow(window);
  return found;
}

void startGlew() {
  glewExperimental = GL_TRUE;  // core profiles have no extension string for it to read
  GLenum const code = glewInit();
  if (code != GLEW_OK && code != GLEW_ERROR_NO_GLX_DISPLAY)  // Wayland has no GLX, and needs none
    throw Error(fmt::format("no window: GLEW: {}; {}", reinterpret_cast<const char*>(glewGetErrorString(code)), remedy),
                ExitCode::noDevice);
  clearGlErrors();
}

}  // namespace

Window::Window(const std::string& title, int width, int height, bool resizable) : title_(title) {
  latestProblem().clear();
  glfwSetErrorCallback(onError);
  if (!glfwInit()) throw Error(fmt::format("no window: {}; {}", latestProblem(), remedy), ExitCode::noDevice);
  try {
    window_ = open(title, width, height, resizable, 4, 5);
    if (!window_) window_ = open(title, width, height, resizable, 3, 3);
    if (!window_)
      throw Error(fmt::format("no window: {}, and 3.3 core is needed; update the graphics driver, or {}",
                              foundInstead(), remedy),
                  ExitCode::noDevice);
    glfwMakeContextCurrent(window_);
    startGlew();
  } catch (...) {
    glfwTerminate();
    throw;
  }
  glVersion_ = glText(GL_VERSION);
  glRenderer_ = glText(GL_RENDERER);
  setVsync(true);
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
    Window& self = windowOf(window);
    self.active_ = true;
    if (action == GLFW_PRESS) self.taps_.push_back({key, modifiers});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { windowOf(w).active_ = true; });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { windowOf(w).active_ = true; });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { windowOf(w).active_ = true; });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { windowOf(w).active_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { windowOf(w).active_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { windowOf(w).active_ = true; });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { windowOf(w).active_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    windowOf(window).active_ = true;
    auto& dropped = windowOf(window).dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Size Window::framebufferSize() const {
  Size size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return minimised() ? Size{} : size;
}

Size Window::windowSize() const {
  Size size;
  glfwGetWindowSize(window_, &size.width, &size.height);
  return size;
}

float Window::contentScale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(std::max(x, y), 0.5f, 8.0f);
}

bool Window::minimised() const { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE; }
bool Window::shouldClose() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void Window::setTitle(const std::string& title) {
  if (std::exchange(title_, title) != title) glfwSetWindowTitle(window_, title.c_str());  // a round trip each
}

void Window::resize(int width, int height) { glfwSetWindowSize(window_, std::max(width, 1), std::max(height, 1)); }
void Window::setVsync(bool on) { glfwSwapInterval(on ? 1 : 0); }

void Window::poll(double timeoutSeconds) {
  if (timeoutSeconds > 0)
    glfwWaitEventsTimeout(timeoutSeconds);
  else
    glfwPollEvents();
}

void Window::swap() { glfwSwapBuffers(window_); }
bool Window::takeActivity() { return std::exchange(active_, false); }
std::vector<Window::KeyTap> Window::takeKeyTaps() { return std::exchange(taps_, {}); }

std::vector<std::string> Window::takeDroppedFiles() { return std::exchange(dropped_, {}); }

}  // namespace ropelight::view
