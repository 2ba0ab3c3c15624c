#pragma once
// Text → double.

#include <string_view>

namespace ropelight {

/// The double nearest to a decimal number such as -1, +.5, 2. or 1E-3, whatever the locale; 0 where it underflows,
/// infinite where it overflows or says so, NaN where the word is no number.
double parseDecimal(std::string_view word);

}  // namespace ropelight
