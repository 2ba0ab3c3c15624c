#pragma once
// What a `params(visitor)` list says of each value: loader, command line, panel and documentation all walk the lists.

#include <limits>
#include <span>

namespace ropelight {

/// A word that a value may be.
struct ChoiceInfo {
  const char* name;
  const char* doc;
};

/// Limits are inclusive. A visitor is called as v(name, reference, info) for every value in order.
struct ParamInfo {
  const char* doc = "";
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  const char* unit = "";
  const char* group = "";                 ///< heading under which the panel shows it; empty: not in the panel
  std::span<const ChoiceInfo> choices{};  ///< the enumerators, in order; empty: no enum
  double low = 0, high = 0;               ///< range of the panel's slider, where the limits are too wide for one
  bool logarithmic = false;               ///< the slider's scale
  const char* zero = "";                  ///< what 0 stands for, where it stands for an automatic value
};

}  // namespace ropelight
