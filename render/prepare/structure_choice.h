#pragma once
// Which structure is taken where the user leaves the choice: fitted by `ropelight bench kdtree` (docs/decisions.md).

#include <cstdint>

namespace ropelight {

/// Up to this many primitives testing all of them is faster than any structure; beyond, the hierarchy is fastest.
inline constexpr std::uint32_t bruteForceLimit = 24;

}  // namespace ropelight
