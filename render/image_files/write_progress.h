#pragma once

#include <functional>

namespace ropelight {

/// Called now and then while a file is written, with the share that is done, up to 1.
using WriteProgress = std::function<void(double share)>;

}  // namespace ropelight
