#pragma once
// What a `params(visitor)` list says of each value: loader, command line, panel and documentation all walk the lists.

#include <limits>

namespace ropelight {

/// Limits are inclusive. A visitor is called as v(name, reference, info) for every value in order.
struct ParamInfo {
  const char* doc = "";
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  const char* unit = "";
};

}  // namespace ropelight
