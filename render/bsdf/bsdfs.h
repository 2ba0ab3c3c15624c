#pragma once
// The list of BSDFs. A new kind is its own file and one word in each of the two lists.

#include <variant>

#include "render/bsdf/dielectric.h"
#include "render/bsdf/diffuse.h"
#include "render/bsdf/mirror.h"
#include "render/core/list.h"

#ifndef RL_TEST_BSDFS
#define RL_TEST_BSDFS  // what a test adds to the list
#endif

namespace ropelight {

/// A material as the scene holds it; the alternative's index is its kind on every backend.
using MaterialDesc = std::variant<DiffuseParams, MirrorParams, DielectricParams>;

}  // namespace ropelight

namespace ropelight::RL_TARGET {

using Bsdfs = List<Diffuse, Mirror, Dielectric RL_TEST_BSDFS>;

}  // namespace ropelight::RL_TARGET
