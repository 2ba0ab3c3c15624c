#include "app/bench/results/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/arguments/values.h"
#include "app/run/text.h"
#include "app/run/version.h"

namespace ropelight {
namespace {

constexpr std::size_t columns = 8;
using Cells = std::array<std::string, columns>;

/// Empty for values that are unknown.
std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "";
  return std::abs(value) >= std::pow(10, digits) ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

/// Says so where there were fewer runs than asked for.
std::string noteOf(const BenchResult& result, const BenchRow& row) {
  std::size_t const runs = row.seconds.size();
  if (runs == 0 || runs >= std::size_t(std::max(result.repeat, 0))) return row.note;
  return row.note + fmt::format("{}{} run{}", row.note.empty() ? "" : "; ", runs, runs == 1 ? "" : "s");
}

Cells cellsOf(const BenchResult& result, const BenchRow& row) {
  Cells cells = {row.series, row.x, "", "", "", number(row.value, 4), row.unit, noteOf(result, row)};
  if (row.seconds.empty()) return cells;
  Spread const s = summarise(row.seconds);
  cells[2] = (row.estimated ? "~" : "") + number(s.median * 1e3, 4);
  cells[3] = number(s.min * 1e3, 4);
  cells[4] = number(s.max * 1e3, 4);
  return cells;
}

std::string line(const Cells& cells, const std::array<std::size_t, columns>& widths) {
  std::string text = " ";
  for (std::size_t i = 0; i < columns; ++i) {
    bool const numeric = i >= 1 && i <= 5;
    std::string const space(widths[i] - letterCount(cells[i]), ' ');
    text += " " + (numeric ? space + cells[i] : cells[i] + space) + (widths[i] > 0 ? " " : "");
  }
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string toText(const BenchResult& result, const BenchTable& table) {
  std::vector<Cells> lines = {{"", table.x, "median ms", "min", "max", "", "", ""}};
  for (const BenchRow& row : table.rows) lines.push_back(cellsOf(result, row));
  std::array<std::size_t, columns> widths{};
  for (const Cells& cells : lines)
    for (std::size_t i = 0; i < columns; ++i) widths[i] = std::max(widths[i], letterCount(cells[i]));
  std::string text = "\n  " + table.name + "\n";
  for (const Cells& cells : lines) text += line(cells, widths);
  for (const std::string& remark : table.remarks) text += "  " + remark + "\n";
  return text;
}

std::string joined(const std::string& a, const std::string& b) { return a + (a.empty() || b.empty() ? "" : " ") + b; }

std::string toCsv(const BenchResult& result, const BenchTable& table, const BenchRow& row) {
  std::string times = ",,";
  if (!row.seconds.empty()) {
    Spread const s = summarise(row.seconds);
    times = fmt::format("{},{},{}", s.median, s.min, s.max);
  }
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", result.bench, quoteCsv(table.name), quoteCsv(row.series),
                     quoteCsv(row.x), times, std::isfinite(row.value) ? formatValue(row.value) : "", quoteCsv(row.unit),
                     quoteCsv(result.device), result.threads, result.seed,
                     quoteCsv(joined(result.settings, row.settings)), quoteCsv(noteOf(result, row)));
}

nlohmann::ordered_json toJson(const BenchResult& result, const BenchTable& table, const BenchRow& row) {
  nlohmann::ordered_json json = {{"bench", result.bench}, {"table", table.name}, {"series", row.series}, {"x", row.x}};
  if (!row.seconds.empty()) {
    Spread const s = summarise(row.seconds);
    json.update({{"median", s.median}, {"min", s.min}, {"max", s.max}, {"seconds", row.seconds}});
  }
  json.update({{"value", row.value},
               {"unit", row.unit},
               {"estimated", row.estimated},
               {"failed", row.failed},
               {"device", result.device},
               {"threads", result.threads},
               {"seed", result.seed},
               {"options", joined(result.settings, row.settings)},
               {"note", noteOf(result, row)}});
  if (!row.details.is_null()) json.update(row.details);
  return json;
}

CurvePoint pointOf(const BenchRow& row, Plotted what) {
  CurvePoint point{.x = row.place, .y = row.value, .estimated = row.estimated};
  if (row.seconds.empty()) return point;
  Spread const s = summarise(row.seconds);
  if (what == Plotted::milliseconds) return {row.place, s.median * 1e3, s.min * 1e3, s.max * 1e3, row.estimated};
  point.low = row.value * s.median / s.max;
  point.high = row.value * s.median / s.min;
  return point;
}

}  // namespace

Spread summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::size_t const n = values.size();
  return {(values[(n - 1) / 2] + values[n / 2]) / 2, values.front(), values.back()};
}

void BenchRow::setRate(double count, const std::string& what) {
  double const median = summarise(seconds).median;
  value = median > 0 ? count / median * 1e-6 : noValue;
  unit = "M" + what + "/s";
}

bool BenchResult::failed() const {
  return std::any_of(tables.begin(), tables.end(), [](const BenchTable& table) {
    return std::any_of(table.rows.begin(), table.rows.end(), [](const BenchRow& row) { return row.failed; });
  });
}

std::string BenchResult::caption() const {
  return fmt::format("{}{}, seed {}, ropelight {}, median of up to {} runs, bands from the least to the largest\n{}",
                     device, threads > 0 ? fmt::format(", {} threads", threads) : "", seed, version, repeat, settings);
}

std::string toText(const BenchResult& result) {
  std::string text = fmt::format("\n{}: {}{}, seed {}, ropelight {}, up to {} runs\n", result.bench, result.device,
                                 result.threads > 0 ? fmt::format(", {} threads", result.threads) : "", result.seed,
                                 version, result.repeat);
  if (!result.settings.empty()) text += "  " + result.settings + "\n";
  for (const BenchTable& table : result.tables) text += toText(result, table);
  return text;
}

std::string toCsv(const std::vector<BenchResult>& results) {
  std::string csv = "bench,table,series,x,median_s,min_s,max_s,rate,unit,device,threads,seed,settings,note\n";
  for (const BenchResult& result : results)
    for (const BenchTable& table : result.tables)
      for (const BenchRow& row : table.rows) csv += toCsv(result, table, row);
  return csv;
}

nlohmann::ordered_json toJson(const std::vector<BenchResult>& results) {
  auto json = nlohmann::ordered_json::array();
  for (const BenchResult& result : results)
    for (const BenchTable& table : result.tables)
      for (const BenchRow& row : table.rows) json.push_back(toJson(result, table, row));
  return json;
}

std::string grouped(std::uint64_t number) {
  std::string text = fmt::format("{}", number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::vector<Curve> curvesOf(const BenchTable& table, Plotted what) {
  std::vector<Curve> curves;
  for (const BenchRow& row : table.rows) {
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.name == row.series; });
    if (curve == curves.end()) curve = curves.insert(curve, Curve{row.series, {}, true});
    if (!row.failed) curve->points.push_back(pointOf(row, what));
  }
  return curves;
}

}  // namespace ropelight
