#pragma once
// A material as kernels see it: which BSDF, what it scatters, and its constants. Where a surface is hit it is evaluated
// to a BSDF; a parameter that varies over surfaces (a texture) is looked up there and nowhere else.

#include <cstring>

#include "render/bsdf/bsdfs.h"

namespace ropelight::RL_TARGET {

/// kind: index in Bsdfs. lobes: what a BSDF of this material may scatter anywhere, of namespace lobe. Aligned so that a
/// GPU reads the constants in words of 16 bytes.
struct alignas(16) Material {
  std::uint16_t kind = 0;
  std::uint16_t lobes = 0;
  float constants[11] = {};  ///< the BSDF's own

  /// Nothing but single directions: no light is sampled there and no photon gathered.
  RL_HD bool specular() const { return (lobes & lobe::gathered) == 0; }
  /// Photons count by their direction too.
  RL_HD bool glossy() const { return (lobes & lobe::glossy) != 0; }
};

namespace detail {

template <FeatureBits F, class Kinds, class T, class Visit>
RL_HD inline void visitOne(const Material& m, Visit& visit) {
  if constexpr ((F & T::bit) != 0) {
    if (m.kind != Kinds::template indexOf<T>()) return;
    static_assert(sizeof(T) <= sizeof(m.constants));
    T bsdf;
    std::memcpy(&bsdf, m.constants, sizeof(T));
    visit(bsdf);
  }
}

template <FeatureBits F, class Visit, class... Ts>
RL_HD inline void visitAll(const Material& m, Visit& visit, List<Ts...>) {
  (visitOne<F, List<Ts...>, Ts>(m, visit), ...);
}

}  // namespace detail

/// Calls visit(bsdf) with the BSDF's own type; kinds that F leaves out are not compiled in.
template <FeatureBits F, class Kinds = Bsdfs, class Visit>
RL_HD inline void visitBsdf(const Material& m, Visit&& visit) {
  detail::visitAll<F>(m, visit, Kinds{});
}

/// A material with these parameters.
template <class Kinds = Bsdfs, class T>
Material materialOf(const T& bsdf) {
  Material m;
  m.kind = std::uint16_t(Kinds::template indexOf<T>());
  m.lobes = std::uint16_t(bsdf.lobes());
  std::memcpy(m.constants, &bsdf, sizeof(T));
  return m;
}

}  // namespace ropelight::RL_TARGET
