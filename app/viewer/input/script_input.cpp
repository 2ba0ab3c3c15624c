#include "app/viewer/input/script_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace ropelight::view {
namespace {

using Point = std::pair<double, double>;

/// Writes frames one after the other; each starts as the one before it.
class Recorder {
 public:
  explicit Recorder(ScriptInput& now) : now_(now) {}

  ScriptInput& now() { return now_; }
  std::deque<ScriptInput> take() { return std::move(frames_); }

  /// Events that last for one frame are gone in the next.
  void frame(int count = 1) {
    for (int i = 0; i < count; ++i) {
      frames_.push_back(now_);
      now_.wheel = 0;
      now_.text.clear();
    }
  }
  void moveTo(Point p) {
    now_.x = float(p.first);
    now_.y = float(p.second);
    frame();
  }
  void button(int index, bool down) {
    now_.buttons[std::size_t(index)] = down;
    frame();
  }
  void modifiers(bool shift, bool control, bool alt) {
    if (now_.shift == shift && now_.control == control && now_.alt == alt) return;
    now_.shift = shift;
    now_.control = control;
    now_.alt = alt;
    frame();
  }
  void key(int number, int count = 1) {
    now_.key = number;
    frame(count);
    now_.key = -1;
    frame();
  }
  void type(const std::string& text) {
    now_.text = text;
    frame();
    frame();
  }

 private:
  ScriptInput& now_;
  std::deque<ScriptInput> frames_;
};

Point along(const WidgetPlace& p, double share) {
  return {p.left + share * (double(p.right) - p.left), (double(p.top) + p.bottom) / 2};
}

Point from(const ScriptCommand& c, const WidgetPlace& place) {
  if (!c.word.empty()) return along(place, c.name == "drag" ? c.numbers[0] : 0.5);
  return {c.numbers[0], c.numbers[1]};
}

Point to(const ScriptCommand& c, const WidgetPlace& place) {
  return c.word.empty() ? Point{c.numbers[2], c.numbers[3]} : along(place, c.numbers[1]);
}

void click(Recorder& r, const ScriptCommand& c, const WidgetPlace& place) {
  r.moveTo(from(c, place));
  r.modifiers(c.shift, c.control, c.alt);
  r.now().quick = c.twice;
  for (int i = 0; i < (c.twice ? 2 : 1); ++i) {
    r.button(c.button, true);
    r.button(c.button, false);
  }
  r.now().quick = false;
  r.modifiers(false, false, false);
}

void drag(Recorder& r, const ScriptCommand& c, const WidgetPlace& place) {
  Point const a = from(c, place), b = to(c, place);
  r.moveTo(a);
  r.modifiers(c.shift, c.control, c.alt);
  r.button(c.button, true);
  for (int i = 1; i <= c.frames; ++i) {
    double const t = double(i) / c.frames;
    r.moveTo(i == c.frames ? b : Point{a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)});
  }
  r.button(c.button, false);
  r.modifiers(false, false, false);
}

void key(Recorder& r, const ScriptCommand& c) {
  r.modifiers(c.shift, c.control, c.alt);
  r.key(c.key, c.name == "hold" ? c.frames : 1);
  r.modifiers(false, false, false);
}

/// A ctrl+click turns a slider into a text box.
void set(Recorder& r, const ScriptCommand& c, const WidgetPlace& place) {
  r.moveTo(from(c, place));
  r.modifiers(false, true, false);
  r.button(0, true);
  r.button(0, false);
  r.key(GLFW_KEY_A);
  r.modifiers(false, false, false);
  r.type(c.texts[0]);
  r.key(GLFW_KEY_ENTER);
}

}  // namespace

bool pointsAtWidget(const ScriptCommand& c) {
  return !c.word.empty() && (c.name == "click" || c.name == "drag" || c.name == "set");
}

bool pressesButton(const ScriptCommand& c) {
  return c.name == "click" || c.name == "drag" || c.name == "set" || c.name == "press";
}

std::deque<ScriptInput> inputFrames(const ScriptCommand& c, const WidgetPlace& place, ScriptInput& held) {
  Recorder r(held);
  if (c.name == "move") r.moveTo({c.numbers[0], c.numbers[1]});
  if (c.name == "press") r.frame(), r.button(c.button, true);
  if (c.name == "release") r.button(c.button, false);
  if (c.name == "click") click(r, c, place);
  if (c.name == "drag") drag(r, c, place);
  if (c.name == "wheel") r.now().wheel = float(c.numbers[0]), r.frame(2);
  if (c.name == "key" || c.name == "hold") key(r, c);
  if (c.name == "type") r.type(c.word);
  if (c.name == "set") set(r, c, place);
  if (c.name == "frames") r.frame(c.frames);
  if (c.name == "resize") r.frame(3);  // the window system answers later
  std::deque<ScriptInput> frames = r.take();
  if (frames.empty()) frames.push_back(held);
  return frames;
}

ScriptInput scrollTowards(const WidgetPlace& place, float windowHeight, const ScriptInput& held) {
  ScriptInput input = held;
  input.x = (place.left + place.right) / 2;
  input.y = windowHeight * 0.75f;  // where the panel scrolls in low windows too
  input.wheel = (place.top + place.bottom) / 2 < input.y ? 1.0f : -1.0f;
  return input;
}

}  // namespace ropelight::view
