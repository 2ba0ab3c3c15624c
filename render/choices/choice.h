#pragma once
// Closed sets of words: an enum and a table that names its values. Text becomes an enumerator once, where it enters the
// program; command line, files, panel and reports all take the names from the table.

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/core/error.h"
#include "render/core/params.h"

namespace ropelight {

/// A row of a table. Rows stand in the order of their enumerators, which count from 0. A table may hold more of each
/// value: a struct that derives from this one.
template <class E>
struct Choice {
  E value;
  const char* name;
  const char* doc;
};

/// Specialised for every closed set, with `static constexpr … table[]`.
template <class E>
struct ChoicesOf;

template <class E>
concept ChoiceEnum = requires {
  ChoicesOf<E>::table;
};

template <class Table>
constexpr bool isInOrder(const Table& table) {
  for (std::size_t i = 0; i < std::size(table); ++i)
    if (std::size_t(table[i].value) != i) return false;
  return true;
}

/// The row of a value.
template <ChoiceEnum E>
constexpr const auto& choiceOf(E value) {
  static_assert(isInOrder(ChoicesOf<E>::table), "the rows of a table stand in the order of its enumerators");
  return ChoicesOf<E>::table[std::size_t(value)];
}

template <ChoiceEnum E>
constexpr const char* nameOf(E value) {
  return choiceOf(value).name;
}

/// All values in order, as ParamInfo::choices takes them.
template <ChoiceEnum E>
inline constexpr auto choicesOf = [] {
  std::array<ChoiceInfo, std::size(ChoicesOf<E>::table)> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = {ChoicesOf<E>::table[i].name, ChoicesOf<E>::table[i].doc};
  return infos;
}();

template <ChoiceEnum E>
std::vector<std::string> namesOf() {
  std::vector<std::string> names;
  for (const ChoiceInfo& info : choicesOf<E>) names.emplace_back(info.name);
  return names;
}

/// The row of that name; null where there is none.
template <class Table>
constexpr auto findRow(const Table& table, std::string_view name) -> decltype(&table[0]) {
  auto const found =
      std::find_if(std::begin(table), std::end(table), [&](const auto& row) { return name == row.name; });
  return found == std::end(table) ? nullptr : &*found;
}

/// The value of that name.
template <ChoiceEnum E>
constexpr std::optional<E> findChoice(std::string_view name) {
  const auto* const row = findRow(ChoicesOf<E>::table, name);
  return row ? std::optional<E>(row->value) : std::nullopt;
}

/// "WHAT: 'TEXT' is not known; use one of: …", an Error (usage).
template <class Table>
[[noreturn]] void refuseChoice(const std::string& what, const std::string& text, const Table& table) {
  std::string names;
  for (const auto& row : table) names += (names.empty() ? "" : ", ") + std::string(row.name);
  throw Error(what + ": '" + text + "' is not known; use one of: " + names, ExitCode::usage);
}

/// The value of that name. Throws Error (usage) where there is none; `what` says whose value it is.
template <ChoiceEnum E>
E parseChoice(const std::string& what, const std::string& text) {
  if (std::optional<E> const value = findChoice<E>(text)) return *value;
  refuseChoice(what, text, ChoicesOf<E>::table);
}

/// What stands for a value in text and JSON: the name of a choice, any other value itself.
template <class T>
decltype(auto) written(const T& value) {
  if constexpr (ChoiceEnum<T>)
    return nameOf(value);
  else
    return (value);
}

}  // namespace ropelight
