#pragma once
// {"type": NAME, …} → material, for every kind in MaterialDesc.

#include <type_traits>
#include <variant>

#include "render/import/json/json_node.h"
#include "render/scene/scene.h"

namespace ropelight {
namespace detail {

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

template <class Desc, class Params>
Desc readParams(const JsonNode& node) {
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
template <class Desc>
struct Kinds;

template <class... Params>
struct Kinds<std::variant<Params...>> {
  using Desc = std::variant<Params...>;
  static std::vector<std::string> names() { return {Params::name...}; }
  static constexpr Desc (*readers[])(const JsonNode&) = {readParams<Desc, Params>...};
};

}  // namespace detail

/// Keys are the names of the kind's params list, all optional; limits are the list's.
template <class Desc = MaterialDesc>
Desc readMaterial(const JsonNode& node) {
  using Kinds = detail::Kinds<Desc>;
  return Kinds::readers[node.at("type").choice("material type", Kinds::names())](node);
}

}  // namespace ropelight
