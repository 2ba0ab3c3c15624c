// Input scripts: what their lines mean, how bad ones are refused, and the frames that commands become.

#include <doctest/doctest.h>

#include <set>

#include "app/viewer/input/script_input.h"
#include "app/viewer/input/script_parse.h"
#include "app/viewer/input/script_words.h"
#include "render/core/error.h"

using namespace ropelight;
using namespace ropelight::view;

namespace {

ScriptCommand parseOne(const std::string& line) {
  std::vector<ScriptCommand> const commands = parseScript("s", line);
  REQUIRE(commands.size() == 1);
  return commands[0];
}

std::string problemOf(const std::string& text) {
  try {
    parseScript("demo.txt", text);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::badInput);
    return error.what();
  }
  return "none";
}

/// A widget from (100, 20) to (300, 40).
const WidgetPlace widget{100, 20, 300, 40, 1, true};

std::deque<ScriptInput> framesOf(const std::string& line, ScriptInput held = {}) {
  return inputFrames(parseOne(line), widget, held);
}

/// One letter a frame: L, R, M the button that is down, + a key, t text, w wheel, . nothing; modifiers before it.
std::string shape(const std::deque<ScriptInput>& frames) {
  std::string text;
  for (const ScriptInput& f : frames) {
    text += text.empty() ? "" : " ";
    if (f.shift) text += "s";
    if (f.control) text += "c";
    if (f.alt) text += "a";
    if (f.buttons[0]) text += "L";
    if (f.buttons[1]) text += "R";
    if (f.buttons[2]) text += "M";
    if (f.key >= 0) text += "+";
    if (!f.text.empty()) text += "t";
    if (f.wheel != 0) text += "w";
    if (text.empty() || text.back() == ' ') text += ".";
  }
  return text;
}

void checkPlace(const ScriptInput& input, float x, float y) {
  CHECK(input.x == doctest::Approx(x));
  CHECK(input.y == doctest::Approx(y));
}

}  // namespace

TEST_CASE("words, quotes and comments") {
  using Words = std::vector<std::string>;
  CHECK(splitLine("  a\tb  c\r") == Words{"a", "b", "c"});
  CHECK(splitLine("a \"b c\" d\"e f\"g") == Words{"a", "b c", "de fg"});
  CHECK(splitLine(R"("say \"x\\y\"" a\b)") == Words{"say \"x\\y\"", "a\\b"});
  CHECK(splitLine("a#b # c \"d") == Words{"a#b"});
  CHECK(splitLine("# nothing").empty());
  CHECK(splitLine("\"\"") == Words{""});
  CHECK(splitLine("").empty());
}

TEST_CASE("lines are numbered, empty ones and comments left out") {
  auto const commands = parseScript("s", "# a script\n\nquit\r\n   \n  frames 3 # wait\nquit");
  REQUIRE(commands.size() == 3);
  CHECK(commands[0].name == "quit");
  CHECK(commands[0].line == 3);
  CHECK(commands[1].frames == 3);
  CHECK(commands[1].line == 5);
  CHECK(commands[2].line == 6);
  CHECK(parseScript("s", "").empty());
}

TEST_CASE("every command is read") {
  CHECK(parseOne("wait iterations 64").numbers == std::vector<double>{64});
  CHECK(parseOne("wait seconds 0.5").word == "seconds");
  CHECK(parseOne("wait ready").word == "ready");
  CHECK(parseOne("move 10.5 -20").numbers == std::vector<double>{10.5, -20});
  CHECK(parseOne("press middle").button == 2);
  CHECK(parseOne("release right").button == 1);
  CHECK(parseOne("click A/photons").word == "A/photons");
  CHECK(parseOne("click 5 6 double ctrl").twice);
  CHECK(parseOne("click 5 6 double ctrl").control);
  CHECK(parseOne("click 5 6 right").button == 1);
  CHECK(parseOne("drag 1 2 3 4 right frames 7").frames == 7);
  CHECK(parseOne("drag 1 2 3 4 alt left").alt);
  CHECK(parseOne("drag tone/exposure 0.25 0.75").numbers == std::vector<double>{0.25, 0.75});
  CHECK(parseOne("wheel -2").numbers == std::vector<double>{-2});
  CHECK(parseOne("hold w 30 shift").frames == 30);
  CHECK(parseOne("type \"a b\"").word == "a b");
  CHECK(parseOne("set A/photons 1e5").texts == std::vector<std::string>{"1e5"});
  CHECK(parseOne("drop a.json \"b c.exr\"").texts == std::vector<std::string>{"a.json", "b c.exr"});
  CHECK(parseOne("resize 1 1").numbers == std::vector<double>{1, 1});
  CHECK(parseOne("screenshot out.png").word == "out.png");
  CHECK(parseOne("state out.json").word == "out.json");
  CHECK(parseOne("quit").name == "quit");
}

TEST_CASE("keys have GLFW's numbers") {
  for (auto [name, number] :
       {std::pair{"a", 65}, {"Z", 90},      {"0", 48},          {"9", 57},     {"f1", 290},     {"F12", 301},
        {"space", 32},      {"period", 46}, {"backspace", 259}, {"tab", 258},  {"escape", 256}, {"enter", 257},
        {"home", 268},      {"slash", 47},  {"minus", 45},      {"equal", 61}, {"[", 91},       {"right-bracket", 93},
        {"left", 263},      {"right", 262}, {"up", 265},        {"down", 264}}) {
    CAPTURE(name);
    CHECK(keyNumber(name) == number);
  }
  for (const char* name : {"", "f0", "f13", "f01", "spacebar", "ä", "?"}) CHECK(keyNumber(name) == -1);
  ScriptCommand const key = parseOne("key S shift ctrl");
  CHECK(key.key == 83);
  CHECK(key.shift);
  CHECK(key.control);
  CHECK_FALSE(key.alt);
}

TEST_CASE("bad lines are refused with file, line and what was expected") {
  CHECK(problemOf("quit\n\nclik 1 2") ==
        "demo.txt:3: unknown command \"clik\"; did you mean \"click\"?; commands: wait, frames, move, press, release, "
        "click, drag, wheel, key, hold, type, set, drop, resize, screenshot, state, quit");
  CHECK(problemOf("move 1") == "demo.txt:1: the line ends early; expected move X Y");
  CHECK(problemOf("move 1 x") == "demo.txt:1: unexpected \"x\"; expected move X Y");
  CHECK(problemOf("move 1 2 3") == "demo.txt:1: unexpected \"3\"; expected move X Y");
  CHECK(problemOf("move nan 2") == "demo.txt:1: unexpected \"nan\"; expected move X Y");
  CHECK(problemOf("move 1 1e9") == "demo.txt:1: 1e9 is not in [-65536, 65536]; expected move X Y");
  CHECK(problemOf("frames 0") == "demo.txt:1: 0 is not in [1, 100000]; expected frames N");
  CHECK(problemOf("frames 1.5") == "demo.txt:1: unexpected \"1.5\"; expected frames N");
  CHECK(problemOf("wait") == "demo.txt:1: the line ends early; expected wait iterations N | seconds S | ready");
  CHECK(problemOf("wait 5") == "demo.txt:1: unexpected \"5\"; expected wait iterations N | seconds S | ready");
  CHECK(problemOf("press up") == "demo.txt:1: unexpected \"up\"; expected press left|right|middle");
  CHECK(
      problemOf("click a twice") ==
      "demo.txt:1: unexpected \"twice\"; expected click WIDGET|X Y [left|right|middle] [double] [shift] [ctrl] [alt]");
  CHECK(problemOf("key spce") == "demo.txt:1: unknown key \"spce\"; did you mean \"space\"?");
  CHECK(problemOf("hold w") == "demo.txt:1: the line ends early; expected hold NAME FRAMES [shift] [ctrl] [alt]");
  CHECK(problemOf("type a b") == "demo.txt:1: unexpected \"b\"; expected type \"TEXT\"");
  CHECK(problemOf("type \"\"") == "demo.txt:1: unexpected \"\"; expected type \"TEXT\"");
  CHECK(problemOf("type \"a") == "demo.txt:1: a quotation mark is not closed");
  CHECK(problemOf("drop") == "demo.txt:1: the line ends early; expected drop FILE...");
  CHECK(problemOf("resize 0 5") == "demo.txt:1: 0 is not in [1, 16384]; expected resize WIDTH HEIGHT");
  CHECK(problemOf("quit now") == "demo.txt:1: unexpected \"now\"; expected quit");
}

TEST_CASE("the usages name every command") {
  std::set<std::string> names;
  for (const ScriptUsage& usage : scriptUsages()) {
    CHECK(std::string(usage.usage).starts_with(usage.name));
    names.insert(usage.name);
  }
  CHECK(names.size() == 17);
}

TEST_CASE("a click hovers, presses and releases in a frame each") {
  auto const frames = framesOf("click slider");
  CHECK(shape(frames) == ". L .");
  for (const ScriptInput& f : frames) checkPlace(f, 200, 30);
  CHECK(shape(framesOf("click 7 8 right")) == ". R .");
  checkPlace(framesOf("click 7 8 right")[0], 7, 8);
  CHECK(shape(framesOf("click 7 8 ctrl shift")) == ". sc scL sc .");
}

TEST_CASE("a double click is quick") {
  auto const frames = framesOf("click 7 8 double");
  CHECK(shape(frames) == ". L . L .");
  CHECK_FALSE(frames[0].quick);
  for (std::size_t i = 1; i < 5; ++i) CHECK(frames[i].quick);
  ScriptInput held;
  inputFrames(parseOne("click 7 8 double"), widget, held);
  CHECK_FALSE(held.quick);
}

TEST_CASE("a drag goes from one place to the other") {
  auto const frames = framesOf("drag 10 20 50 100 frames 4");
  CHECK(shape(frames) == ". L L L L L .");
  checkPlace(frames[1], 10, 20);
  checkPlace(frames[2], 20, 40);
  checkPlace(frames[5], 50, 100);
  checkPlace(frames[6], 50, 100);
  auto const slider = framesOf("drag slider 0.25 1 frames 1 alt");
  CHECK(shape(slider) == ". a aL aL a .");
  checkPlace(slider[0], 150, 30);
  checkPlace(slider[3], 300, 30);
}

TEST_CASE("keys go down after their modifiers and up before them") {
  CHECK(shape(framesOf("key f")) == "+ .");
  CHECK(shape(framesOf("key s ctrl")) == "c c+ c .");
  CHECK(shape(framesOf("hold w 3 shift")) == "s s+ s+ s+ s .");
  CHECK(framesOf("key f")[0].key == 70);
}

TEST_CASE("set opens a slider's text box, replaces its text and confirms") {
  auto const frames = framesOf("set slider 2.5");
  CHECK(shape(frames) == ". c cL c c+ c . t . + .");
  CHECK(frames[4].key == 65);
  CHECK(frames[7].text == "2.5");
  CHECK(frames[9].key == 257);
}

TEST_CASE("what is held stays held") {
  ScriptInput held;
  CHECK(shape(inputFrames(parseOne("move 3 4"), {}, held)) == ".");
  CHECK(shape(inputFrames(parseOne("press left"), {}, held)) == ". L");
  CHECK(shape(inputFrames(parseOne("move 5 6"), {}, held)) == "L");
  CHECK(shape(inputFrames(parseOne("frames 2"), {}, held)) == "L L");
  CHECK(shape(inputFrames(parseOne("wheel 2"), {}, held)) == "Lw L");
  CHECK(shape(inputFrames(parseOne("type hello"), {}, held)) == "Lt L");
  CHECK(shape(inputFrames(parseOne("key f"), {}, held)) == "L+ L");
  CHECK(shape(inputFrames(parseOne("screenshot a.png"), {}, held)) == "L");
  CHECK(shape(inputFrames(parseOne("release left"), {}, held)) == ".");
  checkPlace(held, 5, 6);
  CHECK(shape({held}) == ".");
}

TEST_CASE("only commands that name a widget point at one") {
  for (const char* line : {"click a", "drag a 0 1", "set a 1"}) CHECK(pointsAtWidget(parseOne(line)));
  for (const char* line : {"click 1 2", "drag 1 2 3 4", "type a", "screenshot a", "wait ready"})
    CHECK_FALSE(pointsAtWidget(parseOne(line)));
  for (const char* line : {"click a", "click 1 2", "press left", "set a 1"}) CHECK(pressesButton(parseOne(line)));
  for (const char* line : {"release left", "key a", "move 1 2"}) CHECK_FALSE(pressesButton(parseOne(line)));
}

TEST_CASE("hidden widgets are scrolled to where the panel scrolls") {
  WidgetPlace const below{100, 900, 300, 920, 1, false}, above{100, -60, 300, -40, 1, false};
  CHECK(scrollTowards(below, 800, {}).wheel == -1);
  CHECK(scrollTowards(above, 800, {}).wheel == 1);
  checkPlace(scrollTowards(below, 800, {}), 200, 600);
}
