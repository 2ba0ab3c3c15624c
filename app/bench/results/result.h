#pragma once
// What a benchmark found: tables of measured rows and plots of them, and the same as text, CSV and JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/plot/svg_plot.h"

namespace ropelight {

/// Median and range of repeated runs, in the unit of the values.
struct Spread {
  double median = 0, min = 0, max = 0;
};

/// Of at least one value.
Spread summarise(std::vector<double> values);

/// One measured configuration. Times are seconds of one run: of wall clock on the CPU, on the device on a GPU.
struct BenchRow {
  std::string series;
  std::string x;                ///< where on the table's axis, as it is printed
  double place = noValue;       ///< the same as a number
  std::vector<double> seconds;  ///< of every run; empty where no time was taken
  double value = noValue;       ///< a rate or whatever else there is to say, in `unit`
  std::string unit;
  std::string settings;    ///< besides the benchmark's own
  std::string note;        ///< what is special: work left out, a check that failed
  bool estimated = false;  ///< seconds scaled up from part of the work
  bool failed = false;     ///< its results were wrong
  nlohmann::ordered_json details;

  /// The rate of `count` items per run, in millions per second.
  void setRate(double count, const std::string& what);
};

struct BenchTable {
  std::string name;
  std::string x;  ///< what distinguishes the rows
  std::vector<BenchRow> rows;
  std::vector<std::string> remarks;  ///< printed below it
};

struct BenchPlot {
  std::string suffix;  ///< the file is BENCH.svg, or BENCH-SUFFIX.svg where not empty
  LinePlot plot;
};

struct BenchResult {
  std::string bench;
  std::string device;
  int threads = 0;  ///< CPU threads asked for; 0: all cores
  std::uint64_t seed = 0;
  std::string settings;
  int repeat = 0;  ///< timed runs, or fewer where they take long
  std::vector<BenchTable> tables;
  std::vector<BenchPlot> plots;

  bool failed() const;
  /// Device, seed, settings and version: a plot's caption.
  std::string caption() const;
};

/// Aligned columns under a heading, for a terminal.
std::string toText(const BenchResult& result);

/// RFC 4180 with the header bench,table,series,x,median_s,min_s,max_s,rate,unit,device,threads,seed,settings,note.
std::string toCsv(const std::vector<BenchResult>& results);

/// One object per row.
nlohmann::ordered_json toJson(const std::vector<BenchResult>& results);

/// With separators: "2,073,600".
std::string grouped(std::uint64_t number);

enum class Plotted { milliseconds, value };

/// A curve for every series of a table, with bands from the least to the largest run.
std::vector<Curve> curvesOf(const BenchTable& table, Plotted what);

}  // namespace ropelight
