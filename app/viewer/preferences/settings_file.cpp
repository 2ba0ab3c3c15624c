// Settings as a JSON file, by the names of Settings::params.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/viewer/preferences/preferences.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/import/json/json_node.h"
#include "render/import/json/json_text.h"
#include "render/text/text_file.h"

namespace ropelight::view {
namespace {

/// Reads the values that are there; the others keep their defaults.
class SettingsReader {
 public:
  SettingsReader(const std::string& file, const nlohmann::json& document) : root_(file, document), json_(document) {}

  template <class T>
  void operator()(const char* name, T& value, const ParamInfo& info) {
    if (auto const node = root_.find(name)) read(*node, json_[name], value, info);
  }

 private:
  template <ChoiceEnum E>
  static void read(const JsonNode& node, const nlohmann::json&, E& value, const ParamInfo&) {
    value = E(node.choice(node.pointer().substr(1), namesOf<E>()));
  }
  static void read(const JsonNode& node, const nlohmann::json&, bool& value, const ParamInfo&) {
    value = node.boolean();
  }
  static void read(const JsonNode& node, const nlohmann::json&, int& value, const ParamInfo& info) {
    value = node.integer(info);
  }
  static void read(const JsonNode& node, const nlohmann::json&, double& value, const ParamInfo& info) {
    value = node.number(info);
  }
  /// All 64 bits, which a double does not have; 1e6 is a whole number too.
  static void read(const JsonNode& node, const nlohmann::json& json, std::uint64_t& value, const ParamInfo& info) {
    constexpr double beyond = 18446744073709551616.0;
    double const x = json.is_number() ? json.get<double>() : std::nan("");
    bool const whole = json.is_number_unsigned() || (x >= 0 && x < beyond && x == std::floor(x));
    if (!whole || !(x >= info.min && x <= info.max))
      node.failExpected(fmt::format("a whole number in [{}, {}]", std::uint64_t(info.min),
                                    info.max < beyond ? std::uint64_t(info.max) : ~std::uint64_t{0}));
    value = json.is_number_unsigned() ? json.get<std::uint64_t>() : std::uint64_t(x);
  }

  JsonNode root_;
  const nlohmann::json& json_;
};

}  // namespace

void saveSettings(const std::filesystem::path& file, const Settings& settings) {
  nlohmann::ordered_json json;
  Settings copy = settings;
  copy.params([&](const char* name, const auto& value, const ParamInfo&) { json[name] = written(value); });
  writeFile(file, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

Settings loadSettings(const std::filesystem::path& file) {
  std::string const name = file.string();
  nlohmann::json const document = parseJson(name, readTextFile(file, "check the path"));
  Settings settings;
  std::vector<std::string> known;
  settings.params([&](const char* key, const auto&, const ParamInfo&) { known.push_back(key); });
  JsonNode(name, document).allowKeys(known);
  settings.params(SettingsReader(name, document));
  return settings;
}

}  // namespace ropelight::view
