#pragma once
// A run of the catalogue as a table, JSON, plots and a page.

#include <nlohmann/json.hpp>

#include "app/plot/svg_plot.h"
#include "app/stress/cases/run.h"

namespace ropelight {

/// What every case is, on standard output. Returns the exit code.
int printCatalogue(const std::vector<StressFamily>& families);

/// A line per case: its verdict and the measurement that is nearest to its bound; all measurements of one that fails.
void printTable(const StressRun& run);

nlohmann::ordered_json toJson(const StressRun& run);

/// Error against the parameter with the bound drawn in; false where nothing is swept.
bool sweepPlot(const StressCase& c, const CaseResult& result, LinePlot& plot);

/// One self-contained page.
std::string stabilityPage(const StressRun& run);

/// stability.html, and an SVG of every sweep, into a folder.
void writeReport(const StressRun& run, const std::string& folder);

/// "holds", "FAILS" or "left out"
const char* verdictName(const CaseResult& result);
/// Of the whole run: "all 38 cases hold", "FAILED: 2 of 38 cases do not hold", …
std::string summary(const StressRun& run);

}  // namespace ropelight
