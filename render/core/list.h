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

namespace detail {
template <template <class...> class Of, class Ignored, class... Ts>
struct AfterFirst {
  using type = Of<Ts...>;
};
}  // namespace detail

/// Of<A, B> from an X-macro of A and B that begins every word with a comma: FromWords<Of, void RL_LIST(RL_WORD)>.
template <template <class...> class Of, class... Words>
using FromWords = typename detail::AfterFirst<Of, Words...>::type;

}  // namespace ropelight
