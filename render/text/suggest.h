#pragma once
// What a user probably meant.

#include <string>
#include <string_view>
#include <vector>

namespace ropelight {

/// `a, b, c`, or `none`.
std::string joinNames(const std::vector<std::string>& names);

/// `; did you mean "x"?` for the known name nearest to `word` by edit distance, or nothing where none is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace ropelight
