#include "render/import/json/json_material.h"

#include <type_traits>

namespace ropelight {
namespace {

template <class T>
T readValue(const JsonNode& node, const ParamInfo& limits) {
  if constexpr (std::is_same_v<T, Rgb>) {
    return node.rgb(limits);
  } else if constexpr (std::is_same_v<T, bool>) {
    return node.boolean();
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(node.integer(limits));
  } else {
    static_assert(std::is_floating_point_v<T>, "teach readValue this type of parameter");
    return static_cast<T>(node.number(limits));
  }
}

template <class Params>
MaterialDesc readParams(const JsonNode& node) {
  Params params;
  std::vector<std::string> keys{"type"};
  params.params([&](const char* name, auto&, const ParamInfo&) { keys.push_back(name); });
  node.allowKeys(keys);
  params.params([&](const char* name, auto& value, const ParamInfo& limits) {
    if (auto member = node.find(name)) value = readValue<std::remove_reference_t<decltype(value)>>(*member, limits);
  });
  return params;
}

/// What there is to know of the alternatives of a variant, in order.
template <class Variant>
struct Kinds;

template <class... Params>
struct Kinds<std::variant<Params...>> {
  static std::vector<std::string> names() { return {Params::name...}; }
  static constexpr MaterialDesc (*readers[])(const JsonNode&) = {readParams<Params>...};
};

}  // namespace

MaterialDesc readMaterial(const JsonNode& node) {
  using Materials = Kinds<MaterialDesc>;
  return Materials::readers[node.at("type").choice("material type", Materials::names())](node);
}

}  // namespace ropelight
