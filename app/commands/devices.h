#pragma once

#include <string>

namespace ropelight {

/// `ropelight devices`: the CPU and the GPUs, and why one cannot be used.
struct DevicesOptions {
  std::string json;  ///< file, "-" for standard output instead of the table, empty for none
};

/// Returns the exit code. Throws Error.
int runDevices(const DevicesOptions& options);

}  // namespace ropelight
