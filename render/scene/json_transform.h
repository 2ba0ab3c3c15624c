#pragma once
// [{"translate": …}, {"rotate": …}, …] → matrix.

#include "render/scene/json_node.h"

namespace ropelight {

/// The operations of a list, the first applied first.
Mat4d readTransform(const JsonNode& node);

}  // namespace ropelight
