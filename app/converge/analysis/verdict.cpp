#include "app/converge/analysis/verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/converge/analysis/figures.h"

namespace ropelight {
namespace {

using Indices = std::vector<std::size_t>;

/// Of the modes that have samples.
Indices measuredModes(const StudyScene& scene) {
  Indices modes;
  for (std::size_t i = 0; i < scene.modes.size(); ++i)
    if (seedsOf(scene.modes[i]) > 0) modes.push_back(i);
  return modes;
}

/// One seed says nothing about chance.
bool haveBands(const StudyScene& scene, const Indices& modes) {
  return std::all_of(modes.begin(), modes.end(), [&](std::size_t i) { return seedsOf(scene.modes[i]) > 1; });
}

/// Modes with an error at equal time, the lowest median first.
Indices ranked(const EqualTime& equal) {
  Indices modes;
  for (std::size_t i = 0; i < equal.bands.size(); ++i)
    if (equal.bands[i]) modes.push_back(i);
  std::stable_sort(modes.begin(), modes.end(),
                   [&](std::size_t a, std::size_t b) { return equal.bands[a]->median < equal.bands[b]->median; });
  return modes;
}

/// The lowest mode and all whose 95% intervals it does not lie clear below; that one alone where it is best.
Indices contenders(const EqualTime& equal) {
  Indices modes = ranked(equal);
  if (modes.empty()) return modes;
  double const high = equal.bands[modes.front()]->likely.high;
  auto const clear = [&](std::size_t i) { return equal.bands[i]->likely.low > high; };
  modes.erase(std::remove_if(modes.begin() + 1, modes.end(), clear), modes.end());
  return modes;
}

std::string bandText(const BandPoint& band) {
  if (band.low == band.high) return figure(band.median);
  return fmt::format("{} ({} to {})", figure(band.median), figure(band.low), figure(band.high));
}

/// "path with 0.01 (0.009 to 0.02), sppm with 0.02 and ray with 1"
std::string list(const StudyScene& scene, const EqualTime& equal, const Indices& modes) {
  std::string text;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const char* const joint = i == 0 ? "" : i + 1 == modes.size() ? " and " : ", ";
    text += fmt::format("{}{} with {}", joint, scene.modes[modes[i]].label, bandText(*equal.bands[modes[i]]));
  }
  return text;
}

/// About the two modes or more that have an error at equal time.
std::string comparison(const StudyScene& scene, const EqualTime& equal, bool trimmed) {
  Indices const order = ranked(equal), close = contenders(equal);
  std::string const when = fmt::format("{} of run time", duration(equal.seconds)), metric = metricName(trimmed);
  if (!haveBands(scene, order))
    return fmt::format(
        "One seed says nothing of chance, so no mode is called best: after {} the lowest {} is that of {}, then {}.",
        when, metric, list(scene, equal, {order[0]}), list(scene, equal, {order[1]}));
  if (close.size() > 1)
    return fmt::format("No mode is called best: after {} the 95% intervals of {} overlap between {}.", when, metric,
                       list(scene, equal, close));
  return fmt::format("After {} {} has the lowest {}: {}; next is {}.", when, scene.modes[order[0]].label, metric,
                     bandText(*equal.bands[order[0]]), list(scene, equal, {order[1]}));
}

std::string unmeasured(const StudyScene& scene) {
  std::string text;
  for (const StudyMode& mode : scene.modes)
    if (seedsOf(mode) == 0) text += fmt::format(" {} has no samples.", mode.label);
  return text;
}

}  // namespace

EqualTime atEqualTime(const StudyScene& scene, bool trimmed) {
  EqualTime equal;
  for (const StudyMode& mode : scene.modes)
    if (auto const end = commonEnd(mode, CurveAxis::seconds, trimmed))
      equal.seconds = !(equal.seconds <= *end) ? *end : equal.seconds;
  for (const StudyMode& mode : scene.modes)
    equal.bands.push_back(bandAt(mode, CurveAxis::seconds, trimmed, equal.seconds));
  return equal;
}

std::optional<std::size_t> bestAtEqualTime(const StudyScene& scene, bool trimmed) {
  EqualTime const equal = atEqualTime(scene, trimmed);
  Indices const measured = measuredModes(scene), close = contenders(equal);
  if (measured.size() < 2 || ranked(equal).size() < measured.size()) return std::nullopt;
  if (close.size() != 1 || !haveBands(scene, measured)) return std::nullopt;
  return close.front();
}

std::optional<std::size_t> firstToReach(const StudyScene& scene, double error, bool trimmed) {
  Indices const modes = measuredModes(scene);
  if (modes.size() < 2 || !haveBands(scene, modes)) return std::nullopt;
  std::vector<TimeTo> times;
  for (std::size_t const i : modes) times.push_back(timeTo(scene.modes[i], error, trimmed));
  auto const beats = [&](std::size_t a, std::size_t b) {
    if (a == b || times[a].likely.high < times[b].likely.low) return true;
    return times[b].reached == 0 && commonEnd(scene.modes[modes[b]], CurveAxis::seconds, trimmed) >= times[a].high;
  };
  for (std::size_t a = 0; a < modes.size(); ++a) {
    std::size_t beaten = 0;
    for (std::size_t b = 0; b < modes.size(); ++b) beaten += beats(a, b) ? 1 : 0;
    if (beaten == modes.size()) return modes[a];
  }
  return std::nullopt;
}

std::string verdictOf(const StudyScene& scene, bool trimmed) {
  Indices const measured = measuredModes(scene);
  if (measured.empty()) return "Nothing was measured.";
  EqualTime const equal = atEqualTime(scene, trimmed);
  Indices const order = ranked(equal);
  if (order.size() < measured.size())
    return "No run time that all modes have an error at, so they are not compared." + unmeasured(scene);
  if (order.size() == 1)
    return fmt::format("{} alone has {} {} after {} of run time.", scene.modes[order[0]].label, metricName(trimmed),
                       bandText(*equal.bands[order[0]]), duration(equal.seconds)) +
           unmeasured(scene);
  return comparison(scene, equal, trimmed) + unmeasured(scene);
}

}  // namespace ropelight
