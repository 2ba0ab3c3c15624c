#pragma once
// Text from the command line to a checked value and back, for every type that a params list holds.

#include <cstdint>
#include <optional>
#include <string>

#include "render/choices/choice.h"
#include "render/core/params.h"

namespace ropelight {

/// Reads all of `text` into `value`. Throws Error (usage) naming `name` where it is not such a value or lies outside
/// info's limits; `value` is then unchanged. NaN is outside every range.
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::string& value);
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, bool& value);
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, int& value);
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::uint64_t& value);
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, double& value);
void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::optional<double>& value);
template <ChoiceEnum E>
void parseValue(const std::string& name, const std::string& text, const ParamInfo&, E& value) {
  value = parseChoice<E>(name, text);
}

/// The shortest text that parseValue reads back to the same value; empty for none.
std::string formatValue(const std::string& value);
std::string formatValue(bool value);
std::string formatValue(int value);
std::string formatValue(std::uint64_t value);
std::string formatValue(double value);
std::string formatValue(std::optional<double> value);
template <ChoiceEnum E>
std::string formatValue(E value) {
  return nameOf(value);
}

/// What the value is, for --help: the doc with its unit and its choices.
std::string describe(const ParamInfo& info);

}  // namespace ropelight
