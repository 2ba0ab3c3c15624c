#pragma once
// Lists of types: a kind of BSDF, light or camera is its own file plus one word in its folder's list.

#include <type_traits>

#include "render/core/hd.h"

namespace ropelight {

template <class T>
struct Type {
  using type = T;
};

template <class... Ts>
struct List {
  static constexpr int size = sizeof...(Ts);

  template <class T>
  static constexpr int indexOf() {
    int index = 0;
    bool found = false;
    ((found = found || std::is_same_v<T, Ts>, index += found ? 0 : 1), ...);
    return index;
  }

  /// Calls f(Type<T>{}, index) for every T in order.
  template <class F>
  static constexpr void forEach(F&& f) {
    int index = 0;
    (f(Type<Ts>{}, index++), ...);
  }
};

}  // namespace ropelight
