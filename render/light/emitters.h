#pragma once
// The list of lights. A new kind is its own file and one word here; its index is its number on every backend.

#include "render/core/list.h"
#include "render/light/emitter.h"
#include "render/light/quad_light.h"
#include "render/light/sphere_light.h"

#ifndef RL_TEST_EMITTERS
#define RL_TEST_EMITTERS  // what a test adds to the list
#endif

namespace ropelight::RL_TARGET {

using Emitters = List<SurfaceEmitter<QuadLight>, SurfaceEmitter<SphereLight> RL_TEST_EMITTERS>;

/// The number of the kind that holds a light of the flat scene.
inline int emitterOf(const FlatScene& flat, const FlatLight& light) {
  int kind = -1;
  Emitters::forEach([&](auto type, int index) {
    using T = typename decltype(type)::type;
    if constexpr (requires { T::holds(flat, light); })  // else a test's, which no scene holds
      if (kind < 0 && T::holds(flat, light)) kind = index;
  });
  return kind;
}

namespace detail {

template <FeatureBits F, class Visit, class... Ts>
RL_HD inline void visitEmitters(const Light& light, Visit& visit, List<Ts...>) {
  auto const one = [&](auto type) {
    using T = typename decltype(type)::type;
    if constexpr ((F & T::bit) != 0)
      if (light.kind == std::uint32_t(Emitters::indexOf<T>())) visit(T{});
  };
  (one(Type<Ts>{}), ...);
}

}  // namespace detail

/// Calls visit(Kind{}) for the kind of a light; kinds that F leaves out are not compiled in.
template <FeatureBits F, class Visit>
RL_HD inline void visitEmitter(const Light& light, Visit&& visit) {
  detail::visitEmitters<F>(light, visit, Emitters{});
}

}  // namespace ropelight::RL_TARGET
