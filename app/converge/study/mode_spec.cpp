#include "app/converge/study/mode_spec.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/arguments/assign_setting.h"
#include "render/core/error.h"
#include "render/integrators/integrator.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

void assign(Settings& settings, const std::string& part, const std::string& label) {
  std::size_t const equals = part.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("--modes {}: '{}' is not KEY=VALUE", label, part), ExitCode::usage);
  std::string const key = part.substr(0, equals), value = part.substr(equals + 1);
  if (key == "mode")
    throw Error(fmt::format("--modes {}: the mode is its first word; leave mode= out", label), ExitCode::usage);
  for (const char* shared : {"width", "height", "aov", "max-depth", "indirect-only"})
    if (key == shared)
      throw Error(fmt::format("--modes {}: {} must be the same for all; give --{}", label, key, key), ExitCode::usage);
  assignSetting(settings, key, key == "gather" && value == "knn" ? "nearest" : value);
}

ModeSpec parseMode(const std::string& label, const Settings& base) {
  std::vector<std::string> const parts = splitText(label, ':');
  std::vector<std::string> const known = namesOf<Mode>();
  std::optional<Mode> const mode = findChoice<Mode>(parts[0]);
  if (!mode)
    throw Error(fmt::format("--modes: '{}' is none of {}{}", parts[0], joinNames(known), suggestion(parts[0], known)),
                ExitCode::usage);
  ModeSpec spec{label, base};
  spec.settings.mode = *mode;
  for (std::size_t i = 1; i < parts.size(); ++i) assign(spec.settings, parts[i], label);
  return spec;
}

}  // namespace

std::vector<std::string> splitText(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (char const c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<ModeSpec> parseModes(const std::string& text, const Settings& base) {
  std::vector<ModeSpec> specs;
  for (const std::string& label : splitText(text, ',')) {
    specs.push_back(parseMode(label, base));
    if (std::count_if(specs.begin(), specs.end(), [&](const ModeSpec& s) { return s.label == label; }) > 1)
      throw Error(fmt::format("--modes: '{}' is there twice; --seeds repeats a mode", label), ExitCode::usage);
  }
  return specs;
}

}  // namespace ropelight
