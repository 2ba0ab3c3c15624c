#pragma once
// A view of contiguous elements that kernels can hold (std::span cannot be used in device code).

#include "render/core/hd.h"

namespace ropelight {

template <class T>
struct Span {
  T* data = nullptr;
  std::uint32_t size = 0;

  RL_HD T& operator[](std::uint32_t i) const { return data[i]; }
  RL_HD bool empty() const { return size == 0; }
  RL_HD T* begin() const { return data; }
  RL_HD T* end() const { return data + size; }
};

}  // namespace ropelight
