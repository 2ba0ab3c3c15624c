// What the viewer keeps between runs, and settings files: there and back, and what damaged files do.

#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/viewer/preferences/preferences.h"
#include "render/core/error.h"
#include "tests/support/scene_files.h"

using namespace ropelight;
using namespace ropelight::view;

namespace {

/// An environment variable during a test.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* const old = std::getenv(name)) old_ = old;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

Preferences unusual() {
  Preferences p;
  p.state.tone = {Curve::falseColour, -1.7f, 0.003f, 1234.5f, false, false};
  p.state.compare.layout = Layout::difference;
  p.state.compare.split = 0.3f;
  p.state.compare.gain = 17.5f;
  p.state.compare.flickerHz = 3.3f;
  p.state.photons = {true, 5.5f, -2.25f, 2, 7, false, false, 12345};
  p.state.tree = {true, 13, true};
  p.state.imageBrightness = 0.1f;
  p.state.matchWindow = p.state.inspectorShown = true;
  p.state.panelShown = p.state.plotShown = false;
  p.state.recent = {"/a/b c.json", "d\"e.obj"};
  p.views.push_back({"from above", {{0.1, 9, 1e-3}, {1, 2, 3}, {0, 0, 1}, 33.3, 0.01, 4.7}});
  p.speed = 0.123456789;
  p.width = 1999;
  p.height = 777;
  return p;
}

/// The file's text for these preferences.
std::string textOf(const Preferences& preferences) {
  TemporaryFolder folder;
  savePreferences(folder / "p.json", preferences);
  return fileBytes(folder / "p.json");
}

struct Loaded {
  Preferences preferences;
  std::string problem;
};

/// Loads a text; the file's name in the problem is replaced by FILE.
Loaded load(const std::string& text) {
  TemporaryFolder folder;
  std::string const file = writeFile(folder, "viewer.json", text);
  Loaded loaded;
  loaded.problem = "of before";
  loaded.preferences = loadPreferences(file, loaded.problem);
  for (std::size_t at; (at = loaded.problem.find(file)) != std::string::npos;)
    loaded.problem.replace(at, file.size(), "FILE");
  return loaded;
}

std::string settingsProblem(const std::string& text) {
  TemporaryFolder folder;
  std::string const file = writeFile(folder, "settings.json", text);
  try {
    loadSettings(file);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::badInput);
    std::string const what = error.what();
    REQUIRE(what.starts_with(file + ": "));
    return what.substr(file.size() + 2);
  }
  return "none";
}

}  // namespace

TEST_CASE("preferences come back as they were saved") {
  TemporaryFolder folder;
  std::filesystem::path const file = folder / "a" / "b" / "viewer.json";
  Preferences const saved = unusual();
  savePreferences(file, saved);
  std::string problem;
  Preferences const p = loadPreferences(file, problem);
  CHECK(problem.empty());
  CHECK(textOf(p) == textOf(saved));
  CHECK(textOf(p) != textOf({}));
  CHECK(p.state.tone.curve == Curve::falseColour);
  CHECK(p.state.tone.exposure == -1.7f);
  CHECK(p.state.compare.layout == Layout::difference);
  CHECK(p.state.photons.most == 12345);
  CHECK(p.state.recent == saved.state.recent);
  CHECK(p.speed == saved.speed);
  REQUIRE(p.views.size() == 1);
  CHECK(p.views[0].name == "from above");
  CHECK(p.views[0].camera.position == Vec3d(0.1, 9, 1e-3));
  CHECK(p.views[0].camera.focusDistance == 4.7);
}

TEST_CASE("every value that the file names is a value that the defaults do not have") {
  nlohmann::json const saved = nlohmann::json::parse(textOf(unusual())), plain = nlohmann::json::parse(textOf({}));
  for (const auto& [group, values] : saved.items()) {
    CAPTURE(group);
    if (!values.is_object()) continue;
    for (const auto& [key, value] : values.items()) {
      CAPTURE(key);
      CHECK(value != plain[group][key]);
    }
  }
}

TEST_CASE("floats are written with the digits that they need") {
  Preferences p;
  p.state.compare.split = 0.1f;
  CHECK(textOf(p).find("\"split\": 0.1,") != std::string::npos);
}

TEST_CASE("a missing file and an unknown place give the defaults") {
  std::string problem = "of before";
  CHECK(textOf(loadPreferences("/nowhere/viewer.json", problem)) == textOf({}));
  CHECK(problem.empty());
  CHECK(textOf(loadPreferences({}, problem)) == textOf({}));
  CHECK(problem.empty());
}

TEST_CASE("a damaged file gives the defaults and says where") {
  CHECK(load("{}").problem.empty());
  Loaded const cut = load(textOf(unusual()).substr(0, 100));
  CHECK(textOf(cut.preferences) == textOf({}));
  CHECK(cut.problem.starts_with("FILE: line "));
  CHECK(load("").problem.starts_with("FILE: line 1, column 1: "));
  CHECK(load("[]").problem == "FILE: top level: expected an object, found an array of 0");
  CHECK(load("{\"speed\": 1, \"speed\": 2}").problem == "FILE: /speed: the key occurs twice; remove one");
  TemporaryFolder folder;
  std::string problem;
  loadPreferences(folder.path(), problem);
  CHECK(problem == folder.path().string() + ": cannot be read: it is a directory; check its permissions");
}

TEST_CASE("each bad value keeps its default, is named, and spoils no other") {
  struct Case {
    const char *pointer, *value, *problem;
  };
  for (const Case& c : {
           Case{"/tone/curve", "\"ace\"",
                "unknown curve \"ace\"; did you mean \"aces\"?; known: linear, reinhard, aces, falseColour"},
           Case{"/tone/curve", "3", "expected a string, found 3"},
           Case{"/tone/exposure", "101", "expected a number in [-100, 100], found 101"},
           Case{"/tone/exposure", "null", "expected a number in [-100, 100], found null"},
           Case{"/tone/exposure", "\"nan\"", "expected a number in [-100, 100], found \"nan\""},
           Case{"/tone/markNonFinite", "1", "expected true or false, found 1"},
           Case{"/compare/split", "-0.1", "expected a number in [0, 1], found -0.1"},
           Case{"/compare/layout", "\"sidebyside\"",
                "unknown layout \"sidebyside\"; did you mean \"sideBySide\"?; known: single, split, sideBySide, "
                "flicker, "
                "difference"},
           Case{"/photons/most", "1.5", "expected a whole number in [0, 1e+08], found 1.5"},
           Case{"/photons", "true", "expected an object, found true"},
           Case{"/tree/depth", "65", "expected a whole number in [0, 64], found 65"},
           Case{"/window/width", "0", "expected a whole number in [64, 16384], found 0"},
           Case{"/window/speed", "0", "expected a number in [1e-09, 1e+09], found 0"},
           Case{"/panels/panel", "\"yes\"", "expected true or false, found \"yes\""},
           Case{"/recent", "{}", "expected an array, found an object"},
           Case{"/recent/0", "7", "expected a string, found 7"},
           Case{"/views/0/camera/up", "[1, 2]", "expected three numbers [x, y, z], found an array of 2"},
           Case{"/views/0/camera/fov", "180", "expected a number in [0.001, 179.9] degrees, found 180"},
       }) {
    CAPTURE(c.pointer);
    nlohmann::json::json_pointer const pointer(c.pointer);
    nlohmann::json json = nlohmann::json::parse(textOf(unusual()));
    json[pointer] = nlohmann::json::parse(c.value);
    Loaded const loaded = load(json.dump());
    CHECK(loaded.problem == std::string("FILE: ") + c.pointer + ": " + c.problem);
    bool const element = std::string(c.pointer).find('0') != std::string::npos;
    if (element) continue;
    nlohmann::json const now = nlohmann::json::parse(textOf(loaded.preferences));
    CHECK(now[pointer] == nlohmann::json::parse(textOf({}))[pointer]);
    json = nlohmann::json::parse(textOf(unusual()));
    json[pointer] = now[pointer];
    CHECK(now == json);
  }
}

TEST_CASE("several problems are several lines, and a scale needs two ends") {
  Loaded const loaded = load(R"({"compare": {"split": 2, "gain": "x"}, "tone": {"falseLow": 20}})");
  CHECK(loaded.problem ==
        "FILE: /compare/split: expected a number in [0, 1], found 2\n"
        "FILE: /compare/gain: expected a number in [0, 1e+09], found \"x\"\n"
        "FILE: /tone/falseHigh: expected more than falseLow, 20, found 10");
  CHECK(loaded.preferences.state.tone.falseLow == ToneSettings{}.falseLow);
}

TEST_CASE("values beyond their limits are saved as the nearest good ones") {
  Preferences p;
  p.state.tone.exposure = 1e30f;
  p.state.compare.split = std::numeric_limits<float>::quiet_NaN();
  p.state.compare.gain = std::numeric_limits<float>::infinity();
  p.width = p.height = 1;
  p.state.recent.assign(1000, "a\xff");
  Loaded const loaded = load(textOf(p));
  CHECK(loaded.problem.empty());
  CHECK(loaded.preferences.state.tone.exposure == 100);
  CHECK(loaded.preferences.state.compare.split == 0.5f);
  CHECK(loaded.preferences.state.compare.gain == 1e9f);
  CHECK(loaded.preferences.width == 64);
  CHECK(loaded.preferences.state.recent.size() == 32);
}

TEST_CASE("preferences that cannot be written leave what was there") {
  TemporaryFolder folder;
  putBytes(folder / "file", "no folder");
  CHECK_THROWS_AS(savePreferences(folder / "file" / "viewer.json", {}), Error);
  CHECK(fileBytes(folder / "file") == "no folder");
  std::filesystem::create_directory(folder / "viewer.json");
  CHECK_THROWS_AS(savePreferences(folder / "viewer.json", {}), Error);
  CHECK(folder.entries() == 2);
}

TEST_CASE("the preferences' file follows the environment") {
  Environment const home("HOME", "/home/somebody");
  {
    Environment const config("XDG_CONFIG_HOME", "/etc/xdg");
    CHECK(preferencesFile() == "/etc/xdg/ropelight/viewer.json");
  }
  for (const char* unusable : {"relative", "", static_cast<const char*>(nullptr)}) {
    Environment const config("XDG_CONFIG_HOME", unusable);
    CHECK(preferencesFile() == "/home/somebody/.config/ropelight/viewer.json");
    Environment const none("HOME", nullptr);
    CHECK(preferencesFile().empty());
  }
}

TEST_CASE("settings come back as they were saved") {
  TemporaryFolder folder;
  Settings settings;
  settings.mode = Mode::path;
  settings.aov = Aov::albedo;
  settings.photons = 4294967295;
  settings.radius = 0.1;
  settings.seed = 18446744073709551615u;
  settings.indirectOnly = true;
  settings.treeDepth = 7;
  saveSettings(folder / "a.json", settings);
  Settings const loaded = loadSettings(folder / "a.json");
  saveSettings(folder / "b.json", loaded);
  CHECK(fileBytes(folder / "a.json") == fileBytes(folder / "b.json"));
  CHECK(loaded.mode == Mode::path);
  CHECK(loaded.aov == Aov::albedo);
  CHECK(loaded.seed == 18446744073709551615u);
  CHECK(loaded.radius == 0.1);
  CHECK(loaded.indirectOnly);
  CHECK(loaded.treeDepth == 7);
}

TEST_CASE("a settings file may hold some of the settings") {
  TemporaryFolder folder;
  Settings const loaded = loadSettings(writeFile(folder, "s.json", R"({"photons": 1e6, "bins": 16.0})"));
  CHECK(loaded.photons == 1000000);
  CHECK(loaded.bins == 16);
  CHECK(loaded.mode == Settings{}.mode);
}

TEST_CASE("bad settings files are refused with file, key and what was expected") {
  CHECK(settingsProblem("{\"photon\": 1}")
            .starts_with("/photon: unknown key; did you mean \"photons\"?; known keys: mode, aov, "));
  CHECK(settingsProblem("{\"mode\": \"pat\"}") ==
        "/mode: unknown mode \"pat\"; did you mean \"path\"?; known: ray, path, sppm");
  CHECK(settingsProblem("{\"mode\": 1}") == "/mode: expected a string, found 1");
  CHECK(settingsProblem("{\"alpha\": 2}") == "/alpha: expected a number in [0.01, 1], found 2");
  CHECK(settingsProblem("{\"alpha\": null}") == "/alpha: expected a number in [0.01, 1], found null");
  CHECK(settingsProblem("{\"bins\": 2.5}") == "/bins: expected a whole number in [2, 1024], found 2.5");
  CHECK(settingsProblem("{\"indirect-only\": 0}") == "/indirect-only: expected true or false, found 0");
  for (const char* bad : {"0", "-1", "1.5", "4294967296", "true", "\"9\""})
    CHECK(settingsProblem(std::string("{\"photons\": ") + bad + "}") ==
          std::string("/photons: expected a whole number in [1, 4294967295], found ") + bad);
  for (const char* bad : {"-1", "18446744073709551616", "1e300"})
    CHECK(settingsProblem(std::string("{\"seed\": ") + bad + "}")
              .starts_with("/seed: expected a whole number in [0, 18446744073709551615], found "));
  CHECK(settingsProblem("[1]") == "top level: expected an object, found an array of 1");
  CHECK(settingsProblem("{").starts_with("line 1, column 2: "));
  CHECK_THROWS_WITH_AS(loadSettings("/nowhere/s.json"),
                       "/nowhere/s.json: cannot be read: No such file or directory; check the path", Error);
}
