#pragma once
// [{"translate": …}, {"rotate": …}, …] → matrix.

#include "render/import/json/json_node.h"

namespace ropelight {

/// The operations of a list, the first applied first.
Mat4d readTransform(const JsonNode& node);

}  // namespace ropelight
