#include "app/viewer/preferences/preferences_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ropelight::view {

std::string inCamelCase(const std::string& name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    bool const begins = i > 0 && name[i - 1] == '-';
    if (name[i] != '-') text += begins ? char(std::toupper(static_cast<unsigned char>(name[i]))) : name[i];
  }
  return text;
}

void addProblem(std::string& problems, const std::string& problem) {
  problems += (problems.empty() ? "" : "\n") + problem;
}

CameraDesc readCamera(const JsonNode& node) {
  constexpr ParamInfo lengths{.min = 0, .max = maxCoordinate};
  node.allowKeys({"position", "target", "up", "fov", "aperture", "focus"});
  CameraDesc c;
  c.position = node.at("position").vector(coordinateLimits);
  c.target = node.at("target").vector(coordinateLimits);
  c.up = node.at("up").vector(coordinateLimits);
  c.verticalFov = node.at("fov").number({.min = minFov, .max = maxFov, .unit = "degrees"});
  c.apertureRadius = node.at("aperture").number(lengths);
  c.focusDistance = node.at("focus").number(lengths);
  return c;
}

void PreferencesReader::strings(const char* key, std::vector<std::string>& values, std::size_t most) {
  read(key, [&](const JsonNode& node) {
    for (const JsonNode& item : node.items())
      if (values.size() < most) attempt([&] { values.push_back(item.string()); });
  });
}

void PreferencesReader::views(const char* key, std::vector<SavedView>& values, std::size_t most) {
  read(key, [&](const JsonNode& node) {
    for (const JsonNode& item : node.items())
      if (values.size() < most)
        attempt([&] { values.push_back({item.at("name").string(), readCamera(item.at("camera"))}); });
  });
}

void PreferencesWriter::strings(const char* key, const std::vector<std::string>& values, std::size_t most) {
  json_[key] = std::vector<std::string>(values.begin(), values.begin() + std::ptrdiff_t(std::min(values.size(), most)));
}

void PreferencesWriter::views(const char* key, const std::vector<SavedView>& values, std::size_t most) {
  json_[key] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i)
    json_[key].push_back(
        {{"name", values[i].name}, {"camera", nlohmann::ordered_json::parse(cameraJson(values[i].camera))}});
}

std::string PreferencesWriter::text() const {
  return json_.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

double PreferencesWriter::shortest(float value) {
  if (!std::isfinite(value)) return double(value);
  double const decimal = std::stod(fmt::format("{}", value));
  return float(decimal) == value ? decimal : double(value);
}

}  // namespace ropelight::view
