#include "app/viewer/input/script.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/text/suggest.h"
#include "render/text/text_file.h"

namespace ropelight::view {
namespace {

constexpr int patience = 60;           // frames for a widget to appear
constexpr int settling = 3;            // frames until the program has seen what the command before did
constexpr double longestWait = 120;    // seconds
constexpr double betweenClicks = 0.4;  // seconds; sooner, ImGui would take two clicks for a double one
constexpr float clickReach = 10;       // window coordinates; farther apart they are two in any case

void send(ImGuiIO& io, const ScriptInput& input) {
  io.MousePos = ImVec2(input.x, input.y);
  std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
  std::copy(input.buttons.begin(), input.buttons.end(), io.MouseDown);
  io.MouseWheel = input.wheel;
  io.MouseWheelH = 0;
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  if (input.key >= 0) io.KeysDown[input.key] = true;
  io.KeyCtrl = input.control;
  io.KeyShift = input.shift;
  io.KeyAlt = input.alt;
  io.KeySuper = false;
  io.ClearInputCharacters();
  if (!input.text.empty()) io.AddInputCharactersUTF8(input.text.c_str());
  if (input.quick) io.DeltaTime = std::min(io.DeltaTime, 0.05f);
}

/// Widgets drawn in the latest frame.
std::vector<std::string> presentWidgets() {
  std::vector<std::string> names;
  for (const auto& [name, place] : widgetPlaces())
    if (place.frame == ImGui::GetFrameCount()) names.push_back(name);
  return names;
}

const WidgetPlace* presentWidget(const std::string& name) {
  auto const found = widgetPlaces().find(name);
  bool const present = found != widgetPlaces().end() && found->second.frame == ImGui::GetFrameCount();
  return present ? &found->second : nullptr;
}

}  // namespace

Script Script::load(const std::string& file) {
  std::vector<ScriptCommand> const commands = parseScript(file, readTextFile(file, "check the path"));
  Script script;
  script.file_ = file;
  script.commands_.assign(commands.begin(), commands.end());
  return script;
}

std::vector<std::string> Script::outputs() const {
  std::vector<std::string> files;
  for (const ScriptCommand& command : commands_)
    if (command.name == "state" || command.name == "screenshot") files.push_back(command.word);
  return files;
}

ScriptRequests Script::apply(ImGuiIO& io, double seconds, double iterations, bool busy) {
  ScriptRequests requests;
  if (!running()) return requests;
  if (frames_.empty()) advance({seconds, iterations, busy, io.DisplaySize.y}, requests);
  ScriptInput input = held_;
  if (!frames_.empty()) {
    input = frames_.front();
    if (seconds >= notBefore_) frames_.pop_front();
  }
  if (input.buttons[0] || input.buttons[1] || input.buttons[2]) {
    lastPress_ = input;
    pressedAt_ = seconds;
  }
  send(io, input);
  return requests;
}

/// One frame of the first command: it ends with finish(), or waits and is asked again in the next frame.
void Script::advance(const Now& now, ScriptRequests& requests) {
  const ScriptCommand& command = commands_.front();
  if (framesHere_++ == 0) startedAt_ = now.seconds;
  if (command.name == "wait") return wait(now);
  if (pointsAtWidget(command)) return point(now);
  ask(requests);
  finish(inputFrames(command, {}, held_));
}

/// A press at the place of the last one waits until it cannot be taken for the second half of a double click.
void Script::finish(std::deque<ScriptInput> frames) {
  const ScriptInput& first = frames.front();
  bool const near = std::abs(first.x - lastPress_.x) < clickReach && std::abs(first.y - lastPress_.y) < clickReach;
  notBefore_ = near && pressesButton(commands_.front()) ? pressedAt_ + betweenClicks : 0;
  frames_ = std::move(frames);
  commands_.pop_front();
  framesHere_ = 0;
}

void Script::fail(const std::string& why) {
  problem_ = fmt::format("{}:{}: {}", file_, commands_.front().line, why);
  commands_.clear();
  frames_.clear();
}

void Script::wait(const Now& now) {
  const ScriptCommand& command = commands_.front();
  double const waited = now.seconds - startedAt_;
  if (framesHere_ > settling && waitOver(now)) return finish({held_});
  if (command.word == "seconds" || waited < longestWait) return;
  if (command.word == "ready") return fail(fmt::format("the program is still busy after {:g} s", longestWait));
  fail(fmt::format("after {:g} s A has {:g} of {:g} iterations", longestWait, now.iterations, command.numbers[0]));
}

bool Script::waitOver(const Now& now) {
  const ScriptCommand& command = commands_.front();
  if (command.word == "ready") return !now.busy;
  if (command.word == "iterations") return now.iterations >= command.numbers[0];
  return now.seconds >= startedAt_ + command.numbers[0];
}

/// A widget that its panel's scrolling hides is scrolled into view, as a person does.
void Script::point(const Now& now) {
  const ScriptCommand& command = commands_.front();
  const WidgetPlace* const place = presentWidget(command.word);
  float const middle = place ? (place->top + place->bottom) / 2 : 0;
  if (place && place->visible && middle >= 0 && middle < now.windowHeight)
    return finish(inputFrames(command, *place, held_));
  if (command.optional && framesHere_ > settling && (!place || framesHere_ > patience)) return finish({held_});
  if (framesHere_ < patience) {
    if (place) frames_.push_back(scrollTowards(*place, now.windowHeight, held_));
    return;
  }
  if (place) return fail(fmt::format("the widget '{}' is out of sight and cannot be scrolled to", command.word));
  fail(fmt::format("no widget '{}' on the screen; there are: {}", command.word, joinNames(presentWidgets())));
}

void Script::ask(ScriptRequests& requests) {
  const ScriptCommand& command = commands_.front();
  if (command.name == "drop") requests.drop = command.texts;
  if (command.name == "state") requests.stateFiles.push_back(command.word);
  if (command.name == "screenshot") requests.screenshots.push_back(command.word);
  if (command.name == "quit") requests.quit = true;
  if (command.name != "resize") return;
  requests.resizeWidth = int(command.numbers[0]);
  requests.resizeHeight = int(command.numbers[1]);
}

}  // namespace ropelight::view
