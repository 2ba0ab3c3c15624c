#pragma once
// A JSON value that knows where it came from: every access is checked, every failure names file and JSON pointer.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/core/params.h"
#include "render/core/vec.h"

namespace ropelight {

class JsonNode {
 public:
  /// The file name and the value must outlive the node.
  JsonNode(const std::string& file, const nlohmann::json& value, std::string pointer = "")
      : file_(&file), value_(&value), pointer_(std::move(pointer)) {}

  /// "FILE: POINTER: PROBLEM".
  [[noreturn]] void fail(const std::string& problem) const;
  /// "FILE: POINTER: expected WHAT, found VALUE".
  [[noreturn]] void failExpected(const std::string& what) const;

  /// Refuses anything but an object whose keys are among these.
  void allowKeys(const std::vector<std::string>& known) const;
  /// The value of a key of an object; nothing where it is absent.
  std::optional<JsonNode> find(const std::string& key) const;
  /// The value of a key that must be there.
  JsonNode at(const std::string& key) const;
  /// The keys of an object in alphabetical order.
  std::vector<std::string> keys() const;
  /// The elements of an array.
  std::vector<JsonNode> items() const;

  bool isArray() const { return value_->is_array(); }
  bool isNumber() const { return value_->is_number(); }
  const std::string& file() const { return *file_; }
  const std::string& pointer() const { return pointer_; }

  std::string string() const;
  bool boolean() const;
  /// Within the limits, which are inclusive.
  double number(const ParamInfo& limits) const;
  int integer(const ParamInfo& limits) const;
  /// [x, y, z].
  Vec3d vector(const ParamInfo& limits) const;
  /// [r, g, b], or one number for a grey.
  Rgb rgb(const ParamInfo& limits) const;
  /// A string that is one of `known`; its index. `what` says what the names are.
  std::size_t choice(const std::string& what, const std::vector<std::string>& known) const;

 private:
  void requireObject() const;
  std::string place() const;

  const std::string* file_;
  const nlohmann::json* value_;
  std::string pointer_;
};

}  // namespace ropelight
