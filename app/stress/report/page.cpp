#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/converge/html/parts.h"
#include "app/converge/html/style.h"
#include "app/run/progress.h"
#include "app/run/text.h"
#include "app/stress/report/report.h"
#include "render/image_files/atomic_file.h"

namespace ropelight {
namespace {

/// "light pipe" → "transport-light-pipe"
std::string fileName(const CaseResult& result) {
  std::string name = result.family + "-" + result.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string fact(const char* term, const std::string& text) {
  return text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escapeMarkup(text));
}

std::string measurementTable(const StressCase& c, const CaseResult& result) {
  HtmlTable table;
  table.headsHtml = {
      "series", escapeMarkup(*c.parameter ? c.parameter : "parameter"), "value", "standard error", "expected", "bound",
      "verdict"};
  for (const Measurement& m : result.measurements)
    table.rows.push_back({{escapeMarkup(m.series)},
                          {fmt::format("{:.4g}", m.parameter)},
                          {fmt::format("{:.6g}", m.value)},
                          {fmt::format("{:.2g}", m.noise)},
                          {fmt::format("{:.6g}", m.expected)},
                          {fmt::format("{:.2g}", m.bound)},
                          {m.verdict(), !m.holds()}});
  return "<div class=\"scroll\">" + toHtml(table) + "</div>\n";
}

std::string caseHtml(const StressRun& run, const CaseResult& result) {
  const StressCase& c = run.caseOf(result);
  std::string html = fmt::format("<h3 id=\"{}\">{} <small>{}</small></h3>\n<dl>\n", fileName(result),
                                 escapeMarkup(result.name), verdictName(result));
  html += fact("hard", c.hard) + fact("measured", c.quantity) + fact("against", c.reference) + fact("bound", c.bound);
  html += fact("left out", result.leftOut);
  html += fact("time", formatDuration(result.seconds)) + "</dl>\n";
  if (result.nonFinite > 0) html += paragraph("warning", fmt::format("{} samples were not finite.", result.nonFinite));
  LinePlot plot;
  if (sweepPlot(c, result, plot))
    html += "<div class=\"plots\">" + imageHtml("image/svg+xml", toSvg(plot), plot.title) + "</div>\n";
  return html + (result.measurements.empty() ? "" : measurementTable(c, result));
}

std::string overview(const StressRun& run) {
  HtmlTable table;
  table.headsHtml = {"case", "family", "error", "allowed", "verdict"};
  for (const CaseResult& result : run.results) {
    const Measurement* const worst = result.worst();
    table.rows.push_back({{fmt::format("<a href=\"#{}\">{}</a>", fileName(result), escapeMarkup(result.name))},
                          {escapeMarkup(result.family)},
                          {worst ? fmt::format("{:.3g}", worst->error()) : ""},
                          {worst ? fmt::format("{:.3g}", worst->bound + 4 * worst->noise) : ""},
                          {verdictName(result), result.verdict() == Holds::no}});
  }
  return "<div class=\"scroll\">" + toHtml(table) + "</div>\n";
}

}  // namespace

bool sweepPlot(const StressCase& c, const CaseResult& result, LinePlot& plot) {
  std::map<std::string, std::map<double, std::pair<double, double>>> series;  // error and what is allowed
  std::set<double> parameters;
  for (const Measurement& m : result.measurements) {
    series[m.series][m.parameter] = {m.error(), m.bound + 4 * m.noise};
    parameters.insert(m.parameter);
  }
  bool const positive = !parameters.empty() && *parameters.begin() > 0;
  if (parameters.size() < 3 || !*c.parameter) return false;
  plot = {};
  plot.title = result.name;
  plot.x = {c.parameter, positive, {}};
  plot.y = {"error of " + std::string(c.quantity), true, {}};
  Curve allowed{"allowed", {}, true};
  std::map<double, double> widest;
  for (const auto& [name, points] : series) {
    Curve curve{name, {}, true};
    for (const auto& [x, y] : points) {
      curve.points.push_back({x, y.first});
      widest[x] = std::max(widest[x], y.second);
    }
    plot.curves.push_back(curve);
  }
  for (const auto& [x, y] : widest) allowed.points.push_back({x, y});
  plot.curves.push_back(allowed);
  plot.caption = fmt::format("allowed: {}, and four standard errors", c.bound);
  return true;
}

std::string stabilityPage(const StressRun& run) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  html += fmt::format("<title>ropelight: stability</title><style>{}</style></head><body>\n", htmlStyle);
  html += "<h1>Stiff and extreme cases</h1>\n";
  html += paragraph("lead", fmt::format("{} ({}), seed {}{}, in {}", run.device, run.backend, run.seed,
                                        run.isShort ? ", the short catalogue" : "", formatDuration(run.seconds)));
  html += paragraph(run.failed() ? "warning" : "verdict", summary(run) + ".");
  html += overview(run);
  for (const StressFamily& family : run.families) {
    html += fmt::format("<section><h2>{} <small>{}</small></h2>\n", family.name, escapeMarkup(family.about));
    for (const CaseResult& result : run.results)
      if (result.family == family.name) html += caseHtml(run, result);
    html += "</section>\n";
  }
  return html + "</body></html>\n";
}

void writeReport(const StressRun& run, const std::string& folder) {
  writeFile(folder + "/stability.html", stabilityPage(run));
  for (const CaseResult& result : run.results) {
    LinePlot plot;
    if (sweepPlot(run.caseOf(result), result, plot)) writeFile(folder + "/" + fileName(result) + ".svg", toSvg(plot));
  }
}

}  // namespace ropelight
