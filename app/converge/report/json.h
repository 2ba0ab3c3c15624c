#pragma once
// A study as JSON.

#include <nlohmann/json.hpp>

#include "app/converge/analysis/study.h"

namespace ropelight {

/// Everything but the pictures. Values that are not known become null.
nlohmann::ordered_json toJson(const Study& study);

}  // namespace ropelight
