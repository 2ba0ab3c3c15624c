#include "app/viewer/input/script_parse.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>

#include "app/viewer/input/script_words.h"
#include "render/core/error.h"
#include "render/text/suggest.h"

namespace ropelight::view {
namespace {

constexpr double farthest = 65536;  // window coordinates
constexpr double mostFrames = 100000, mostSeconds = 86400;

bool takeModifier(Words& w, ScriptCommand& c) {
  if (w.take("shift")) return c.shift = true;
  if (w.take("ctrl")) return c.control = true;
  if (w.take("alt")) return c.alt = true;
  return false;
}

bool takeButton(Words& w, ScriptCommand& c) {
  static constexpr const char* buttons[] = {"left", "right", "middle"};
  for (int i = 0; i < 3; ++i)
    if (w.take(buttons[i])) {
      c.button = i;
      return true;
    }
  return false;
}

void places(Words& w, ScriptCommand& c, int count) {
  for (int i = 0; i < count; ++i) c.numbers.push_back(w.number(-farthest, farthest));
}

void parseWait(Words& w, ScriptCommand& c) {
  if (w.take("ready")) return void(c.word = "ready");
  if (w.take("iterations")) {
    c.word = "iterations";
    c.numbers.push_back(w.whole(0, 1e9));
  } else {
    if (!w.take("seconds")) w.refuse();
    c.word = "seconds";
    c.numbers.push_back(w.number(0, mostSeconds));
  }
}

void parseFrames(Words& w, ScriptCommand& c) { c.frames = w.whole(1, mostFrames); }
void parseMove(Words& w, ScriptCommand& c) { places(w, c, 2); }
void parseButton(Words& w, ScriptCommand& c) {
  if (!takeButton(w, c)) w.refuse();
}

void parseClick(Words& w, ScriptCommand& c) {
  if (w.isNumber() && w.isNumber(1))
    places(w, c, 2);
  else
    c.word = w.word();
  while (!w.empty()) {
    if (w.take("double"))
      c.twice = true;
    else if (!takeButton(w, c) && !takeModifier(w, c))
      w.refuse();
  }
}

void parseDrag(Words& w, ScriptCommand& c) {
  c.frames = 10;
  if (w.isNumber()) {
    places(w, c, 4);
  } else {
    c.word = w.word();
    for (int i = 0; i < 2; ++i) c.numbers.push_back(w.number(-10, 10));
  }
  while (!w.empty()) {
    if (w.take("frames"))
      c.frames = w.whole(1, mostFrames);
    else if (!takeButton(w, c) && !takeModifier(w, c))
      w.refuse();
  }
}

void parseWheel(Words& w, ScriptCommand& c) { c.numbers.push_back(w.number(-1000, 1000)); }

std::vector<std::string> keyNames();

void parseKeyName(Words& w, ScriptCommand& c) {
  std::string const name = w.word();
  c.key = keyNumber(name);
  if (c.key < 0) throw Refusal{fmt::format("unknown key \"{}\"{}", name, suggestion(name, keyNames()))};
}

void parseKey(Words& w, ScriptCommand& c) {
  parseKeyName(w, c);
  while (takeModifier(w, c)) {
  }
}

void parseHold(Words& w, ScriptCommand& c) {
  parseKeyName(w, c);
  c.frames = w.whole(1, mostFrames);
  while (takeModifier(w, c)) {
  }
}

void parseWord(Words& w, ScriptCommand& c) { c.word = w.word(); }

void parseSet(Words& w, ScriptCommand& c) {
  c.word = w.word();
  c.texts.push_back(w.word());
}

void parseDrop(Words& w, ScriptCommand& c) {
  do c.texts.push_back(w.word());
  while (!w.empty());
}

void parseResize(Words& w, ScriptCommand& c) {
  for (int i = 0; i < 2; ++i) c.numbers.push_back(w.whole(1, 16384));
}

void parseNothing(Words&, ScriptCommand&) {}

struct Grammar {
  const char* name;
  const char* usage;
  void (*parse)(Words&, ScriptCommand&);
};

constexpr Grammar grammar[] = {
    {"wait", "wait iterations N | seconds S | ready", parseWait},
    {"frames", "frames N", parseFrames},
    {"move", "move X Y", parseMove},
    {"press", "press left|right|middle", parseButton},
    {"release", "release left|right|middle", parseButton},
    {"click", "click WIDGET|X Y [left|right|middle] [double] [shift] [ctrl] [alt]", parseClick},
    {"drag", "drag X1 Y1 X2 Y2|WIDGET FROM TO [left|right|middle] [frames N] [shift] [ctrl] [alt]", parseDrag},
    {"wheel", "wheel N", parseWheel},
    {"key", "key NAME [shift] [ctrl] [alt]", parseKey},
    {"hold", "hold NAME FRAMES [shift] [ctrl] [alt]", parseHold},
    {"type", "type \"TEXT\"", parseWord},
    {"set", "set WIDGET VALUE", parseSet},
    {"drop", "drop FILE...", parseDrop},
    {"resize", "resize WIDTH HEIGHT", parseResize},
    {"screenshot", "screenshot FILE", parseWord},
    {"state", "state FILE", parseWord},
    {"quit", "quit", parseNothing},
};

const std::map<std::string, int>& namedKeys() {
  static const std::map<std::string, int> keys = {
      {"space", GLFW_KEY_SPACE},    {"period", GLFW_KEY_PERIOD},
      {"tab", GLFW_KEY_TAB},        {"backspace", GLFW_KEY_BACKSPACE},
      {"escape", GLFW_KEY_ESCAPE},  {"enter", GLFW_KEY_ENTER},
      {"home", GLFW_KEY_HOME},      {"end", GLFW_KEY_END},
      {"slash", GLFW_KEY_SLASH},    {"minus", GLFW_KEY_MINUS},
      {"equal", GLFW_KEY_EQUAL},    {"left-bracket", GLFW_KEY_LEFT_BRACKET},
      {"left", GLFW_KEY_LEFT},      {"right-bracket", GLFW_KEY_RIGHT_BRACKET},
      {"right", GLFW_KEY_RIGHT},    {"up", GLFW_KEY_UP},
      {"down", GLFW_KEY_DOWN},      {"[", GLFW_KEY_LEFT_BRACKET},
      {"]", GLFW_KEY_RIGHT_BRACKET}};
  return keys;
}

std::vector<std::string> keyNames() {
  std::vector<std::string> names;
  for (const auto& [name, number] : namedKeys()) names.push_back(name);
  return names;
}

ScriptCommand parseLine(std::vector<std::string> line) {
  ScriptCommand command;
  command.name = line[0];
  std::vector<std::string> names;
  for (const Grammar& g : grammar) {
    names.push_back(g.name);
    if (command.name != g.name) continue;
    Words words({line.begin() + 1, line.end()}, g.usage);
    g.parse(words, command);
    if (!words.empty()) words.refuse();
    return command;
  }
  throw Refusal{
      fmt::format("unknown command \"{}\"{}; commands: {}", line[0], suggestion(line[0], names), joinNames(names))};
}

}  // namespace

int keyNumber(const std::string& name) {
  std::string lower = name;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  if (lower.size() == 1 && lower[0] >= 'a' && lower[0] <= 'z') return GLFW_KEY_A + (lower[0] - 'a');
  if (lower.size() == 1 && lower[0] >= '0' && lower[0] <= '9') return GLFW_KEY_0 + (lower[0] - '0');
  for (int i = 1; i <= 12; ++i)
    if (lower == fmt::format("f{}", i)) return GLFW_KEY_F1 + i - 1;
  auto const found = namedKeys().find(lower);
  return found == namedKeys().end() ? -1 : found->second;
}

std::vector<ScriptCommand> parseScript(const std::string& file, const std::string& text) {
  std::vector<ScriptCommand> commands;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    try {
      std::vector<std::string> words = splitLine(line);
      if (words.empty()) continue;
      bool const optional = words.size() > 1 && words[0] == "try";
      if (optional) words.erase(words.begin());
      commands.push_back(parseLine(std::move(words)));
      commands.back().line = number;
      commands.back().optional = optional;
    } catch (const Refusal& refusal) {
      throw Error(fmt::format("{}:{}: {}", file, number, refusal.why));
    }
  }
  return commands;
}

std::vector<ScriptUsage> scriptUsages() {
  std::vector<ScriptUsage> usages;
  for (const Grammar& g : grammar) usages.push_back({g.name, g.usage});
  return usages;
}

}  // namespace ropelight::view
