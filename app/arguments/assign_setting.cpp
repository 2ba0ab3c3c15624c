#include "app/arguments/assign_setting.h"

#include <fmt/format.h>

#include "app/arguments/values.h"
#include "render/core/error.h"
#include "render/text/suggest.h"

namespace ropelight {

void assignSetting(Settings& settings, const std::string& key, const std::string& text) {
  bool found = false;
  std::vector<std::string> names;
  settings.params([&](const std::string& name, auto& value, const ParamInfo& info) {
    names.push_back(name);
    if (name != key) return;
    parseValue("-D " + name, text, info, value);
    found = true;
  });
  if (found) return;
  throw Error(
      fmt::format("-D {}: there is no such setting{}; there are: {}", key, suggestion(key, names), joinNames(names)),
      ExitCode::usage);
}

}  // namespace ropelight
