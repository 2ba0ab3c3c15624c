#include "app/arguments/values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "render/core/error.h"

namespace ropelight {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& text, const std::string& expected) {
  throw Error(fmt::format("{}: '{}' is not {}", name, text, expected), ExitCode::usage);
}

std::string range(const ParamInfo& info) {
  if (!std::isfinite(info.min) && !std::isfinite(info.max)) return "";
  std::string const unit = *info.unit ? fmt::format(" {}", info.unit) : "";
  if (!std::isfinite(info.max)) return fmt::format(" of at least {}{}", info.min, unit);
  return fmt::format(" from {} to {}{}", info.min, info.max, unit);
}

template <class T>
void parseNumber(const std::string& name, const std::string& text, const ParamInfo& info, const std::string& kind,
                 T& value) {
  T parsed{};
  const char* const end = text.data() + text.size();
  auto const [stop, status] = std::from_chars(text.data(), end, parsed);
  bool const inside = double(parsed) >= info.min && double(parsed) <= info.max;
  if (status != std::errc{} || stop != end || !inside) refuse(name, text, kind + range(info));
  value = parsed;
}

}  // namespace

void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::string& value) {
  if (text.empty()) refuse(name, text, info.doc);
  value = text;
}

void parseValue(const std::string& name, const std::string& text, const ParamInfo&, bool& value) {
  bool const yes = text == "true" || text == "on" || text == "1";
  bool const no = text == "false" || text == "off" || text == "0";
  if (!yes && !no) refuse(name, text, "true or false");
  value = yes;
}

void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, int& value) {
  parseNumber(name, text, info, "a whole number", value);
}

void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::uint64_t& value) {
  parseNumber(name, text, info, "a whole number", value);
}

void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, double& value) {
  parseNumber(name, text, info, "a number", value);
}

void parseValue(const std::string& name, const std::string& text, const ParamInfo& info, std::optional<double>& value) {
  double number = 0;
  parseValue(name, text, info, number);
  value = number;
}

std::string formatValue(const std::string& value) { return value; }
std::string formatValue(bool value) { return value ? "true" : "false"; }
std::string formatValue(int value) { return fmt::format("{}", value); }
std::string formatValue(std::uint64_t value) { return fmt::format("{}", value); }
std::string formatValue(double value) { return fmt::format("{}", value); }
std::string formatValue(std::optional<double> value) { return value ? formatValue(*value) : ""; }

std::string describe(const ParamInfo& info) {
  std::string text = *info.unit ? fmt::format("{} ({})", info.doc, info.unit) : std::string(info.doc);
  for (const ChoiceInfo& choice : info.choices)
    text += fmt::format("{}{} ({})", &choice == info.choices.data() ? ": " : ", ", choice.name, choice.doc);
  return text;
}

}  // namespace ropelight
