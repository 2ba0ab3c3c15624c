#pragma once
// Which side of a surface emits.

#include <cstdint>

namespace ropelight {

enum class Side : std::uint8_t { out = 1, in = 2, both = 3 };

}  // namespace ropelight
