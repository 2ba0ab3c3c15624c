#include "app/converge/html/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/results/result.h"
#include "app/converge/analysis/figures.h"
#include "app/converge/analysis/verdict.h"
#include "app/converge/html/parts.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

constexpr double summaryError = 0.01;

std::string slopeHtml(const Slope& slope) {
  return rangeHtml(slopeFigure(slope.median), slopeFigure(slope.low), slopeFigure(slope.high));
}

std::string bandHtml(const std::optional<BandPoint>& band) { return band ? rangeHtml(*band) : "–"; }

/// Over the runs' last samples, in the unit of `value`.
template <class Value>
Spread lastOf(const StudyMode& mode, Value value) {
  std::vector<double> values;
  for (const StudyRun& run : mode.runs)
    if (!run.samples.empty()) values.push_back(value(run.samples.back()));
  return values.empty() ? Spread{unknown, unknown, unknown} : summarise(values);
}

/// Each run's own end: unlike at equal time, not all of them need be there.
std::string endHtml(const StudyMode& mode, bool trimmed) {
  if (seedsOf(mode) == 0) return "–";
  Spread const error = lastOf(mode, [&](const ErrorSample& s) { return errorOf(s.metrics, trimmed); });
  Spread const seconds = lastOf(mode, [](const ErrorSample& s) { return s.seconds; });
  Spread const iterations = lastOf(mode, [](const ErrorSample& s) { return double(s.iterations); });
  return fmt::format("{}<small>{}, {} iterations</small>",
                     rangeHtml(figure(error.median), figure(error.min), figure(error.max)), duration(seconds.median),
                     grouped(std::uint64_t(std::llround(iterations.median))));
}

std::vector<std::string> errorHeads(bool trimmed, double equalTime) {
  std::vector<std::string> heads = {"mode"};
  for (double const error : reportedErrors)
    heads.push_back(fmt::format("seconds to<br>{} {}", metricName(trimmed), error));
  heads.push_back(fmt::format("error at equal<br>time, {}", duration(equalTime)));
  for (const char* head : {"error at the end", "slope over<br>seconds", "slope over<br>iterations"})
    heads.push_back(head);
  return heads;
}

/// With its share of the whole.
std::string shareHtml(double part, double whole) {
  if (!std::isfinite(part) || !(whole > 0)) return figure(part);
  return fmt::format("{}<small>{:.3g}%</small>", figure(part), 100 * part / whole);
}

std::string biasHtml(const ErrorSplit& split, int seeds) {
  if (split.bias2 < 0) return fmt::format("<span class=\"quiet\">below what {} seeds can show</span>", seeds);
  return shareHtml(split.bias2, split.mse);
}

std::vector<std::string> labelsOf(const Study& study) {
  std::vector<std::string> labels;
  for (const StudyScene& scene : study.scenes)
    for (const StudyMode& mode : scene.modes)
      if (std::find(labels.begin(), labels.end(), mode.label) == labels.end()) labels.push_back(mode.label);
  return labels;
}

std::vector<HtmlCell> summaryRow(const StudyScene& scene, const std::vector<std::string>& labels, bool trimmed) {
  EqualTime const equal = atEqualTime(scene, trimmed);
  auto const best = bestAtEqualTime(scene, trimmed), first = firstToReach(scene, summaryError, trimmed);
  std::vector<HtmlCell> row = {
      {fmt::format("{}<small class=\"quiet\"> at {}</small>", escapeMarkup(scene.name), duration(equal.seconds))}};
  for (const std::string& label : labels) {
    auto const mode = std::find_if(scene.modes.begin(), scene.modes.end(), [&](auto& m) { return m.label == label; });
    if (mode == scene.modes.end()) {
      row.insert(row.end(), {{"–"}, {"–"}});
      continue;
    }
    auto const index = std::size_t(mode - scene.modes.begin());
    row.push_back({timeHtml(timeTo(*mode, summaryError, trimmed), seedsOf(*mode)), first == index});
    row.push_back({bandHtml(equal.bands[index]), best == index});
  }
  return row;
}

}  // namespace

std::string summaryTable(const Study& study) {
  std::vector<std::string> const labels = labelsOf(study);
  HtmlTable table;
  std::string groups, heads;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    groups += fmt::format("<th scope=\"colgroup\" colspan=\"2\" class=\"group\">{}</th>", modeHtml(labels[i], i));
    heads += fmt::format("<th scope=\"col\">seconds to {}</th><th scope=\"col\">error</th>", summaryError);
  }
  for (const StudyScene& scene : study.scenes) table.rows.push_back(summaryRow(scene, labels, study.trimmed));
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th rowspan=\"2\" scope=\"col\">scene</th>{}</tr>\n<tr "
      "class=\"second\">{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      groups, heads, rowsHtml(table));
}

std::string errorTable(const Study& study, const StudyScene& scene) {
  EqualTime const equal = atEqualTime(scene, study.trimmed);
  HtmlTable table{errorHeads(study.trimmed, equal.seconds), {}};
  auto const best = bestAtEqualTime(scene, study.trimmed);
  for (std::size_t i = 0; i < scene.modes.size(); ++i) {
    const StudyMode& mode = scene.modes[i];
    std::vector<HtmlCell> row = {{modeHtml(mode.label, i)}};
    for (double const error : reportedErrors)
      row.push_back({timeHtml(timeTo(mode, error, study.trimmed), seedsOf(mode)),
                     firstToReach(scene, error, study.trimmed) == i});
    row.push_back({bandHtml(equal.bands[i]), best == i});
    row.push_back({endHtml(mode, study.trimmed)});
    for (CurveAxis const axis : {CurveAxis::seconds, CurveAxis::iterations})
      row.push_back({slopeHtml(slopeOf(mode, axis, study.trimmed))});
    table.rows.push_back(std::move(row));
  }
  return toHtml(table);
}

std::string splitTable(const Study&, const StudyScene& scene) {
  HtmlTable table{{"mode", "mean square error", "bias²", "variance of one run", "variance of the reference"}, {}};
  for (std::size_t i = 0; i < scene.modes.size(); ++i) {
    const ErrorSplit& split = scene.modes[i].split;
    table.rows.push_back({{modeHtml(scene.modes[i].label, i)},
                          {figure(split.mse)},
                          {biasHtml(split, seedsOf(scene.modes[i]))},
                          {shareHtml(split.variance, split.mse)},
                          {shareHtml(split.referenceVariance, split.mse)}});
  }
  return toHtml(table);
}

std::string edgeTable(const StudyScene& scene) {
  HtmlTable table{{"mode", "of the pixels", "of the error", "error there / elsewhere"}, {}};
  auto const percent = [](double share) { return share >= 0 ? fmt::format("{:.3g}%", 100 * share) : "–"; };
  for (std::size_t i = 0; i < scene.modes.size(); ++i) {
    const EdgeShare& e = scene.modes[i].pictureEdges;
    double const ratio = e.error / e.pixels * ((1 - e.pixels) / (1 - e.error));
    table.rows.push_back(
        {{modeHtml(scene.modes[i].label, i)}, {percent(e.pixels)}, {percent(e.error)}, {figure(ratio)}});
  }
  return toHtml(table);
}

std::string startTable(const Study& study, const StudyScene& scene) {
  HtmlTable table{{"mode", "process start", "scene load", "set-up", "of it the tree", "first iteration", "together"},
                  {}};
  for (std::size_t i = 0; i < scene.modes.size(); ++i) {
    const StudyMode& mode = scene.modes[i];
    double const sum = study.startSeconds + scene.loadSeconds + mode.setupSeconds + mode.firstIterationSeconds;
    table.rows.push_back({{modeHtml(mode.label, i)},
                          {duration(study.startSeconds)},
                          {duration(scene.loadSeconds)},
                          {duration(mode.setupSeconds)},
                          {mode.treeSeconds > 0 ? duration(mode.treeSeconds) : "–"},
                          {duration(mode.firstIterationSeconds)},
                          {duration(sum)}});
  }
  return toHtml(table);
}

}  // namespace ropelight
