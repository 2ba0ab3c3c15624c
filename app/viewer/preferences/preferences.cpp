#include "app/viewer/preferences/preferences.h"

#include <fmt/format.h>

#include <cstdlib>

#include "app/viewer/preferences/preferences_file.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/import/json/json_text.h"
#include "render/text/text_file.h"

namespace ropelight::view {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostRecent = 32, mostViews = 256;

// One list per group: the same names and limits for reading and for writing.

template <class V>
void tone(V& v, ToneSettings& t) {
  v.choice("curve", t.curve);
  v("exposure", t.exposure, -100, 100);
  v("falseLow", t.falseLow, -1e30, 1e30);
  v("falseHigh", t.falseHigh, -1e30, 1e30);
  v("falseLogarithmic", t.falseLogarithmic);
  v("markNonFinite", t.markNonFinite);
}

/// What costs machine time (B, an accumulated reference) must be asked for again in every run.
template <class V>
void compare(V& v, CompareSettings& c) {
  v.choice("layout", c.layout);
  v("split", c.split, 0, 1);
  v("gain", c.gain, 0, 1e9);
  v("flickerHz", c.flickerHz, 0.01, 100);
}

template <class V>
void photons(V& v, PhotonOverlay& p) {
  v("shown", p.shown);
  v("size", p.size, 0.1, 256);
  v("brightness", p.brightness, -100, 100);
  v("fewestBounces", p.fewestBounces, 0, 1024);
  v("mostBounces", p.mostBounces, 0, 1024);
  v("global", p.global);
  v("caustic", p.caustic);
  v("most", p.most, 0, 100000000);
}

template <class V>
void tree(V& v, TreeOverlay& t) {
  v("shown", t.shown);
  v("depth", t.depth, 0, 64);
  v("onlyDeepest", t.onlyDeepest);
}

template <class V>
void panels(V& v, ViewState& s) {
  v("panel", s.panelShown);
  v("inspector", s.inspectorShown);
  v("plot", s.plotShown);
  v("imageBrightness", s.imageBrightness, 0, 1);
  v("matchWindow", s.matchWindow);
}

template <class V>
void window(V& v, Preferences& p) {
  v("width", p.width, 64, 16384);
  v("height", p.height, 64, 16384);
  v("speed", p.speed, 1e-9, 1e9);
}

template <class V>
void groups(V&& v, Preferences& p) {
  v.group("window", [&](auto& g) { window(g, p); });
  v.group("tone", [&](auto& g) { tone(g, p.state.tone); });
  v.group("compare", [&](auto& g) { compare(g, p.state.compare); });
  v.group("photons", [&](auto& g) { photons(g, p.state.photons); });
  v.group("tree", [&](auto& g) { tree(g, p.state.tree); });
  v.group("panels", [&](auto& g) { panels(g, p.state); });
  v.strings("recent", p.state.recent, mostRecent);
  v.views("views", p.views, mostViews);
}

/// A scale must have two ends.
void mendScale(const std::string& file, ToneSettings& t, std::string& problem) {
  if (t.falseLow < t.falseHigh) return;
  ToneSettings const defaults;
  addProblem(problem, fmt::format("{}: /tone/falseHigh: expected more than falseLow, {}, found {}", file, t.falseLow,
                                  t.falseHigh));
  t.falseLow = defaults.falseLow;
  t.falseHigh = defaults.falseHigh;
}

void makeFolder(const fs::path& file) {
  std::error_code error;
  if (!file.has_parent_path()) return;
  fs::create_directories(file.parent_path(), error);
  if (error)
    throw Error(
        fmt::format("{}: the folder {} cannot be made: {}; make it or set XDG_CONFIG_HOME to one that can be "
                    "written",
                    file.string(), file.parent_path().string(), error.message()));
}

}  // namespace

fs::path preferencesFile() {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  fs::path folder = config ? config : "";
  if (!folder.is_absolute()) {  // which the XDG base directory specification says to ignore
    const char* const home = std::getenv("HOME");
    if (!home || !fs::path(home).is_absolute()) return {};
    folder = fs::path(home) / ".config";
  }
  return folder / "ropelight" / "viewer.json";
}

Preferences loadPreferences(const fs::path& file, std::string& problem) {
  Preferences preferences;
  problem.clear();
  std::error_code ignored;
  if (file.empty() || fs::status(file, ignored).type() == fs::file_type::not_found) return preferences;
  try {
    std::string const name = file.string();
    nlohmann::json const document = parseJson(name, readTextFile(file, "check its permissions"));
    groups(PreferencesReader(JsonNode(name, document), problem), preferences);
    mendScale(name, preferences.state.tone, problem);
  } catch (const Error& error) {
    addProblem(problem, error.what());
  }
  return preferences;
}

void savePreferences(const fs::path& file, const Preferences& preferences) {
  Preferences copy = preferences;
  PreferencesWriter writer;
  groups(writer, copy);
  makeFolder(file);
  writeFile(file, writer.text());
}

}  // namespace ropelight::view
