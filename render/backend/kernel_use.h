#pragma once
// What a kernel takes of a GPU.

#include <cstddef>

namespace ropelight {

struct KernelUse {
  const char* stage = "";
  const char* row = "";        ///< of kernelRows
  int registers = 0;           ///< of a thread
  std::size_t localBytes = 0;  ///< of a thread: its stack and what was spilled
  int architecture = 0;        ///< of the code that was loaded, 90 for compute capability 9.0
};

}  // namespace ropelight
