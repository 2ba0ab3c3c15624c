#pragma once
// What the reader and the writer of OpenEXR files share.

#include <string_view>

namespace ropelight {

/// Prefix of the attributes that hold our metadata.
inline constexpr std::string_view exrPrefix = "ropelight.";

/// Threads for OpenEXR's own pool, one per core; creates the pool.
int exrThreads();

}  // namespace ropelight
