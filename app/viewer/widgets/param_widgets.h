#pragma once
// Widgets from what a `params` list says of its values: labels in a left column, widgets right of them, each marked
// "prefix/name". They know limits, units and choices, and nothing about particular settings.

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "render/choices/choice.h"
#include "render/core/params.h"

namespace ropelight::view {

/// The label in the left column, its unit after it and a tooltip over both; the next item fills the right column.
void rowLabel(const char* name, const ParamInfo& info);
/// Broken between words at the end of the line, never within a number.
void wrappedText(const std::string& text);
/// A row that shows a text.
void valueRow(const char* name, const std::string& text, const char* doc = "");
/// Doc, limits and unit, while the latest item is hovered.
void paramTip(const ParamInfo& info);

/// Each draws a row and returns true where the value changed. `resolved` is what an automatic value came to.
bool editParam(const std::string& prefix, const char* name, bool& value, const ParamInfo& info, bool resolved = false);
bool editParam(const std::string& prefix, const char* name, int& value, const ParamInfo& info, int resolved = 0);
bool editParam(const std::string& prefix, const char* name, std::uint64_t& value, const ParamInfo& info,
               std::uint64_t resolved = 0);
bool editParam(const std::string& prefix, const char* name, float& value, const ParamInfo& info, float resolved = 0);
bool editParam(const std::string& prefix, const char* name, double& value, const ParamInfo& info, double resolved = 0);

/// A combo of info.choices whose entries are the enumerators in order. Where the first stands for an automatic value
/// (info.zero), `resolved` is what it came to.
bool editChoice(const std::string& prefix, const char* name, int& index, const ParamInfo& info, int resolved = 0);
template <ChoiceEnum E>
bool editParam(const std::string& prefix, const char* name, E& value, const ParamInfo& info, E resolved = {}) {
  int index = int(value);
  bool const changed = editChoice(prefix, name, index, info, int(resolved));
  if (changed) value = E(index);
  return changed;
}

/// The groups of a list in order of first appearance.
template <class P>
std::vector<std::string> paramGroups(P& list) {
  std::vector<std::string> groups;
  list.params([&](const char*, auto&, const ParamInfo& info) {
    bool known = !*info.group;
    for (const std::string& group : groups) known = known || group == info.group;
    if (!known) groups.emplace_back(info.group);
  });
  return groups;
}

/// The value of that name and type; T{} where there is none.
template <class T, class P>
T paramValue(P& list, const std::string& name) {
  T found{};
  list.params([&](const char* key, auto& value, const ParamInfo&) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, T>)
      if (name == key) found = value;
  });
  return found;
}

/// Rows of one group; true where a value changed. `resolved` is the same list without automatic values.
template <class P>
bool editGroup(const std::string& prefix, const std::string& group, P& list, P& resolved) {
  bool changed = false;
  list.params([&](const char* name, auto& value, const ParamInfo& info) {
    using T = std::decay_t<decltype(value)>;
    if (group == info.group) changed |= editParam(prefix, name, value, info, paramValue<T>(resolved, name));
  });
  return changed;
}

}  // namespace ropelight::view
