#pragma once
// What reading and writing OpenEXR files have in common.

#include <string_view>

namespace ropelight {

/// Of the attributes that hold our metadata.
inline constexpr std::string_view exrPrefix = "ropelight.";

/// Threads for OpenEXR's own pool, one a core; makes the pool.
int exrThreads();

}  // namespace ropelight
