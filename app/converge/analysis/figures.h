#pragma once
// Numbers as the report writes them.

#include <string>

#include "app/converge/analysis/study.h"

namespace ropelight {

/// Three digits: "0.0123", "4.56·10⁻⁵"; "–" where unknown.
std::string figure(double value);
/// The same with two decimals and a true minus sign: "−0.98".
std::string slopeFigure(double value);
/// With its unit, "12.3 ms" or "4.56 s".
std::string duration(double seconds);

/// The name of errorOf's figure.
const char* metricName(bool trimmed);

/// "all CPU threads", "1 CPU thread", "2 CPU threads"; of the number asked for.
std::string threadsText(int threads);

/// What the scene was run on: the study's device where the scene does not say.
const std::string& deviceOf(const Study& study, const StudyScene& scene);

}  // namespace ropelight
