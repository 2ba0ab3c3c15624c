#pragma once
// The two visitors of a list of preferences: one reads a JSON object with a default for every value that is damaged,
// the other writes one with every value inside its limits.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "app/viewer/camera/camera_control.h"
#include "render/choices/choice.h"
#include "render/core/error.h"
#include "render/import/json/json_node.h"

namespace ropelight::view {

/// As preferences spell names: side-by-side becomes sideBySide.
std::string inCamelCase(const std::string& name);

/// Appends a line.
void addProblem(std::string& problems, const std::string& problem);

/// The camera of a scene file's "camera" object. Throws Error where it is none.
CameraDesc readCamera(const JsonNode& node);

class PreferencesReader {
 public:
  /// `problems` collects a line for every value that was left at its default. Throws Error where node is no object.
  PreferencesReader(const JsonNode& node, std::string& problems) : node_(node), problems_(problems) { node_.keys(); }

  void operator()(const char* key, bool& value) {
    read(key, [&](const JsonNode& node) { value = node.boolean(); });
  }

  template <class T>
  void operator()(const char* key, T& value, double min, double max) {
    ParamInfo const limits{.min = min, .max = max};
    read(key, [&](const JsonNode& node) {
      if constexpr (std::is_integral_v<T>)
        value = T(node.integer(limits));
      else
        value = T(node.number(limits));
    });
  }

  template <ChoiceEnum E>
  void choice(const char* key, E& value) {
    std::vector<std::string> names;
    for (const std::string& name : namesOf<E>()) names.push_back(inCamelCase(name));
    read(key, [&](const JsonNode& node) { value = E(node.choice(key, names)); });
  }

  template <class List>
  void group(const char* key, List list) {
    read(key, [&](const JsonNode& node) {
      PreferencesReader reader(node, problems_);
      list(reader);
    });
  }

  void strings(const char* key, std::vector<std::string>& values, std::size_t most);
  void views(const char* key, std::vector<SavedView>& values, std::size_t most);

 private:
  template <class Read>
  void read(const char* key, Read readNode) {
    if (auto const node = node_.find(key)) attempt([&] { readNode(*node); });
  }

  template <class Action>
  void attempt(Action action) {
    try {
      action();
    } catch (const Error& error) {
      addProblem(problems_, error.what());
    }
  }

  JsonNode node_;
  std::string& problems_;
};

class PreferencesWriter {
 public:
  void operator()(const char* key, bool& value) { json_[key] = value; }

  /// NaN is left out, so that the default is found next time.
  template <class T>
  void operator()(const char* key, T& value, double min, double max) {
    if (!(value == value)) return;
    if constexpr (std::is_integral_v<T>)
      json_[key] = std::clamp(value, T(min), T(max));
    else
      json_[key] = std::clamp(shortest(value), min, max);
  }

  template <ChoiceEnum E>
  void choice(const char* key, E& value) {
    if (std::size_t(value) < choicesOf<E>.size()) json_[key] = inCamelCase(nameOf(value));
  }

  template <class List>
  void group(const char* key, List list) {
    PreferencesWriter writer;
    list(writer);
    json_[key] = writer.json_;
  }

  void strings(const char* key, const std::vector<std::string>& values, std::size_t most);
  void views(const char* key, const std::vector<SavedView>& values, std::size_t most);

  std::string text() const;

 private:
  /// The double with the fewest digits that is read back to the same value.
  static double shortest(float value);
  static double shortest(double value) { return value; }

  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

}  // namespace ropelight::view
