#pragma once
// The report's tables.

#include <string>

#include "app/converge/analysis/report.h"

namespace ropelight {

/// Scenes × modes: the time to relMSE 0.01 and the error at equal time.
std::string summaryTable(const Study& study);

/// The other tables are of one scene, one row per mode: times to an error, error at the end, slopes.
std::string errorTable(const Study& study, const StudyScene& scene);
/// Mean square errors, bias² and variance.
std::string splitTable(const Study& study, const StudyScene& scene);
/// How much of the error at equal time sits near edges.
std::string edgeTable(const StudyScene& scene);
/// The time before the curves begin.
std::string startTable(const Study& study, const StudyScene& scene);
/// What differs from the defaults, one line per mode, and all settings folded away.
std::string settingsHtml(const StudyScene& scene);

}  // namespace ropelight
