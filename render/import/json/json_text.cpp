#include "render/import/json/json_text.h"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "render/core/error.h"

namespace ropelight {
namespace {

using nlohmann::json;

/// Follows the parser, so that errors inside a document can be located.
class PlaceTracker {
 public:
  explicit PlaceTracker(const std::string& file) : file_(file) {}

  void operator()(json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
        levels_.push_back({false, {}, {}, 0});
        return;
      case json::parse_event_t::array_start:
        levels_.push_back({true, {}, {}, 0});
        return;
      case json::parse_event_t::key:
        enterKey(parsed.get<std::string>());
        return;
      case json::parse_event_t::value:
        next();
        return;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end:
        levels_.pop_back();
        next();
        return;
    }
  }

  /// Of the value that the parser stands before.
  std::string pointer() const {
    std::string text;
    for (const Level& level : levels_)
      text += "/" + (level.isArray ? std::to_string(level.index) : pointerToken(level.key));
    return text;
  }

 private:
  struct Level {
    bool isArray;
    std::set<std::string> keys;
    std::string key;
    std::size_t index;
  };

  void next() {
    if (!levels_.empty()) ++levels_.back().index;
  }

  void enterKey(std::string key) {
    bool const isNew = levels_.back().keys.insert(key).second;
    levels_.back().key = std::move(key);
    if (!isNew) throw Error(fmt::format("{}: {}: the key occurs twice; remove one", file_, pointer()));
  }

  const std::string& file_;
  std::vector<Level> levels_;
};

/// The library's text without its own prefix: "line 3, column 7: syntax error while parsing …".
std::string positionAndProblem(const json::parse_error& error) {
  std::string const text = error.what();
  std::string const prefix = "parse error at ";
  std::size_t const start = text.find(prefix);
  return start == std::string::npos ? text : text.substr(start + prefix.size());
}

}  // namespace

std::string pointerToken(const std::string& key) {
  std::string token;
  for (char const c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

json parseJson(const std::string& file, const std::string& text) {
  PlaceTracker tracker(file);
  auto track = [&tracker](int, json::parse_event_t event, json& parsed) {
    tracker(event, parsed);
    return true;
  };
  try {
    return json::parse(text, track);
  } catch (const json::parse_error& error) {
    throw Error(fmt::format("{}: {}", file, positionAndProblem(error)));
  } catch (const json::out_of_range&) {
    throw Error(fmt::format("{}: {}: the number is too large for double precision", file, tracker.pointer()));
  }
}

}  // namespace ropelight
