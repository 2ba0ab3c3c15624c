#include "app/stress/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/stress/families/families.h"
#include "render/core/error.h"

namespace ropelight {

std::vector<StressFamily> stressCatalogue(const families::RayOptions& rays) {
  return {families::transport(), families::dielectrics(), families::scale(),  families::geometry(),
          families::photons(),   families::length(),      families::limits(), families::files(),
          families::twin(),      families::rays(rays)};
}

namespace {

void requireNames(const std::vector<StressFamily>& all, const std::vector<std::string>& names) {
  std::set<std::string> known;
  std::string list;
  for (const StressFamily& f : all) {
    known.insert(f.name);
    list += fmt::format("\n  {}:", f.name);
    for (const StressCase& c : f.cases) {
      known.insert(c.name);
      list += fmt::format(" '{}'", c.name);
    }
  }
  for (const std::string& name : names)
    if (!known.contains(name))
      throw Error(fmt::format("stress: there is no case or family '{}'; there are{}", name, list), ExitCode::usage);
}

}  // namespace

std::vector<StressFamily> chooseCases(std::vector<StressFamily> all, const std::vector<std::string>& names,
                                      bool isShort) {
  requireNames(all, names);
  auto const asked = [&](const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<StressFamily> chosen;
  for (StressFamily& family : all) {
    bool const whole = asked(family.name);
    std::erase_if(family.cases,
                  [&](const StressCase& c) { return (!whole && !asked(c.name)) || (isShort && !c.isShort); });
    if (!family.cases.empty()) chosen.push_back(std::move(family));
  }
  if (chosen.empty())
    throw Error("stress: none of these cases is in the short catalogue; leave out --short", ExitCode::usage);
  return chosen;
}

}  // namespace ropelight
