#pragma once
// One scene's part of the report.

#include <string>

#include "app/converge/analysis/report.h"

namespace ropelight {

std::string sceneHtml(const Study& study, const StudyScene& scene);

/// The reference, and of every mode that has one the picture at equal time with its error map.
std::string picturesHtml(const StudyScene& scene, bool trimmed);

}  // namespace ropelight
