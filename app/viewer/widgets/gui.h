#pragma once
// Dear ImGui's context, its two backends, and how it looks.

namespace ropelight::view {

class Window;

class Gui {
 public:
  /// For the window whose callbacks of its own are installed already. `scale`: of text and spacing, 1 is 13 pixels.
  Gui(const Window& window, float scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Makes font and style again where the scale has changed; between end() and beginBackends().
  void setScale(float scale);
  float scale() const { return scale_; }

  /// A frame: the backends take input from the window, a script may change ImGui's input, begin() starts the frame.
  void beginBackends();
  void begin();
  /// Draws it over what the window's framebuffer holds.
  void end();

 private:
  float scale_ = 0;
};

}  // namespace ropelight::view
