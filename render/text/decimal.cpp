#include "render/text/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ropelight {
namespace {

/// The power of ten after the e; one beyond 64 bits is as good as one of 10¹⁸.
std::int64_t exponentOf(std::string_view digits) {
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t exponent = 0;
  constexpr std::int64_t huge = 1'000'000'000'000'000'000;
  if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec == std::errc()) return exponent;
  return digits.starts_with('-') ? -huge : huge;
}

/// Of a number beyond the range of double, whether it is too small for it.
bool underflows(std::string_view word) {
  std::size_t const e = word.find_first_of("eE");
  std::int64_t places = 0;  // before the point, or minus the zeros after it
  bool fraction = false, significant = false;
  for (char const c : word.substr(0, e)) {
    if (c == '.') fraction = true;
    if (c < '0' || c > '9') continue;
    significant = significant || c != '0';
    if (significant && !fraction) ++places;
    if (!significant && fraction) --places;
  }
  return places + (e == std::string_view::npos ? 0 : exponentOf(word.substr(e + 1))) < 0;
}

}  // namespace

double parseDecimal(std::string_view word) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (word.starts_with("+-")) return nan;
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  auto const [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem == std::errc::invalid_argument || end != word.data() + word.size()) return nan;
  if (problem == std::errc()) return value;
  double const beyond = underflows(word) ? 0 : std::numeric_limits<double>::infinity();
  return word.starts_with('-') ? -beyond : beyond;
}

}  // namespace ropelight
