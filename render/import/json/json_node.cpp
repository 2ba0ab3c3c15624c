#include "render/import/json/json_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/core/error.h"
#include "render/import/json/json_text.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

using nlohmann::json;

/// The value as the file has it, shortened for a message.
std::string describe(const json& value) {
  constexpr std::size_t longest = 40;
  if (value.is_object()) return "an object";
  if (value.is_array()) return value.size() == 1 ? "an array of 1" : fmt::format("an array of {}", value.size());
  std::string const text = value.dump(-1, ' ', true);
  return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

std::string describeLimits(const ParamInfo& limits) {
  std::string text;
  if (std::isfinite(limits.min) && std::isfinite(limits.max)) {
    text = fmt::format(" in [{:g}, {:g}]", limits.min, limits.max);
  } else if (std::isfinite(limits.min)) {
    text = fmt::format(" of at least {:g}", limits.min);
  } else if (std::isfinite(limits.max)) {
    text = fmt::format(" of at most {:g}", limits.max);
  }
  return *limits.unit ? text + " " + limits.unit : text;
}

}  // namespace

std::string JsonNode::place() const { return pointer_.empty() ? "top level" : pointer_; }

void JsonNode::fail(const std::string& problem) const {
  throw Error(fmt::format("{}: {}: {}", *file_, place(), problem));
}

void JsonNode::failExpected(const std::string& what) const {
  fail(fmt::format("expected {}, found {}", what, describe(*value_)));
}

void JsonNode::requireObject() const {
  if (!value_->is_object()) failExpected("an object");
}

void JsonNode::allowKeys(const std::vector<std::string>& known) const {
  requireObject();
  for (const std::string& key : keys())
    if (std::find(known.begin(), known.end(), key) == known.end())
      at(key).fail(fmt::format("unknown key{}; known keys: {}", suggestion(key, known), joinNames(known)));
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  requireObject();
  auto const found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonNode(*file_, *found, pointer_ + "/" + pointerToken(key));
}

JsonNode JsonNode::at(const std::string& key) const {
  std::optional<JsonNode> node = find(key);
  if (!node) fail(fmt::format("missing key \"{}\"", key));
  return *node;
}

std::vector<std::string> JsonNode::keys() const {
  requireObject();
  std::vector<std::string> names;
  for (const auto& member : value_->items()) names.push_back(member.key());
  return names;
}

std::vector<JsonNode> JsonNode::items() const {
  if (!isArray()) failExpected("an array");
  std::vector<JsonNode> nodes;
  for (const json& element : *value_) nodes.emplace_back(*file_, element, fmt::format("{}/{}", pointer_, nodes.size()));
  return nodes;
}

std::string JsonNode::string() const {
  if (!value_->is_string()) failExpected("a string");
  return value_->get<std::string>();
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) failExpected("true or false");
  return value_->get<bool>();
}

double JsonNode::number(const ParamInfo& limits) const {
  double const x = isNumber() ? value_->get<double>() : std::nan("");
  if (!(x >= limits.min && x <= limits.max)) failExpected("a number" + describeLimits(limits));
  return x;
}

int JsonNode::integer(const ParamInfo& limits) const {
  double const x = isNumber() ? value_->get<double>() : std::nan("");
  bool const fits = std::abs(x) <= 2147483647.0 && x == std::floor(x);
  if (!fits || x < limits.min || x > limits.max) failExpected("a whole number" + describeLimits(limits));
  return static_cast<int>(x);
}

Vec3d JsonNode::vector(const ParamInfo& limits) const {
  if (!isArray() || value_->size() != 3) failExpected("three numbers [x, y, z]");
  std::vector<JsonNode> const x = items();
  return Vec3d(x[0].number(limits), x[1].number(limits), x[2].number(limits));
}

Rgb JsonNode::rgb(const ParamInfo& limits) const {
  if (isNumber()) return Rgb(static_cast<float>(number(limits)));
  if (!isArray() || value_->size() != 3) failExpected("a colour [r, g, b] or one number");
  return Rgb(vector(limits));
}

std::size_t JsonNode::choice(const std::string& what, const std::vector<std::string>& known) const {
  std::string const name = string();
  auto const found = std::find(known.begin(), known.end(), name);
  if (found == known.end())
    fail(fmt::format("unknown {} {}{}; known: {}", what, describe(*value_), suggestion(name, known), joinNames(known)));
  return static_cast<std::size_t>(found - known.begin());
}

}  // namespace ropelight
